// Exercise 07: the functions to write, and what they are given.
#pragma once
#include <vector>

#include "vec.hpp"

/// Where two spheres touch.
struct Contact {
  Vec3 n;                // unit vector from j to i
  double ri, rj, Rstar;  // centre of i, of j to the contact point, effective radius [L]
};
/// What the contact law computes for i: normal, sliding and rolling force, and the twisting force
/// [ML/T^2]. fn is along n, fs and fr are perpendicular to it.
struct Friction {
  Vec3 fn, fs, fr;
  double ft;
};
/// What acts on one body: force [ML/T^2] and torque about its centre [ML^2/T^2].
struct Load {
  Vec3 f, t;
};
/// What a contact does to both of its bodies.
struct Loads {
  Load i, j;
};
/// A contact in a list: the numbers of its bodies, from 0.
struct Pair {
  int i, j;
  Loads loads;
};

/// Force and torque on both bodies of a contact. Eqs. (1), (2), (31)-(33), (56)-(60).
Loads both_sides(const Contact& c, const Friction& f);

/// What acts on each of the bodies 0 ... bodies - 1: the sums of Eqs. (1) and (2), over a list that
/// holds every contact once.
std::vector<Load> total(int bodies, const std::vector<Pair>& pairs);
