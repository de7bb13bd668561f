// Exercise 10: the functions to write, and what they are given.
#pragma once
#include "vec.hpp"

/// The point of the edge from a to b that is closest to p [L]. a may be equal to b.
Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b);

/// The point of the triangle with the corners a, b, c that is closest to p [L]. The corners may lie
/// on a line, or at the same place.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The point of the rectangle with the corners a, b, c, d, in this order around it, that is closest
/// to p [L]. Its sides may have length 0.
Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d);
