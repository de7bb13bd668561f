// Measures one thing per call and prints lines `name,value,unit`. bench.py calls it.
//
//   bench settle KIND N FILE [PARAMETER=VALUE ...]       make a state, let it settle, keep it
//   bench stack BLOCK N FILE [PARAMETER=VALUE ...]       the same from copies of a settled one,
//                                                        across=M: M in x and y, or about a cube
//   bench time FILE [OPTION ...] [PARAMETER=VALUE ...]   time per particle and step, whole and of
//                                                        each block of steps
//   bench memory FILE [OPTION ...] [PARAMETER=VALUE ...] bytes per particle
//   bench has PARAMETER                                  does the solver know it? (1 or 0)
//   bench flags                                          what this was compiled with
//
// Options: mesh=KIND (see states.hpp), steps=N (timed), warm=N (before), repeats=N (from the state
// anew, the median counts), lists=off (do not count steps in which a list is built), horizon=X
// (keep Simulation::horizon at this value; 0: leave it alone, but step by step), spins=off (the
// particles of the state do not spin). Everything else goes to the solver, as in a scene file.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <map>
#include <numeric>

#include "states.hpp"

namespace bench {

// --------------------------------------------------------------------------------- the command

struct Command {
  std::map<string, string> options{
      {"mesh", "box"}, {"steps", "100"}, {"warm", "20"}, {"across", "0"},
      {"repeats", "1"}, {"lists", "on"}, {"horizon", ""}, {"spins", "on"}};
  tinydem::vector<Setting> settings{{"Nspawn", "0", "bench"}, {"Rmesh", "0,0", "bench"}};
  /// Reads words `name=value` from the k-th on.
  Command(const tinydem::vector<string>& words, int k) {
    for (; k < count(words); ++k) {
      const size_t equals = words[k].find('=');
      if (equals == string::npos) throw InputError("'" + words[k] + "' must be name=value");
      const string name = words[k].substr(0, equals), value = words[k].substr(equals + 1);
      if (options.count(name)) options[name] = value;
      else settings.push_back({name, value, "bench"});
    }
  }
  long whole(const string& name, real low, real high) const {
    return long(number(name, low, high));
  }
  real number(const string& name, real low, real high) const {
    real a = 0;
    if (!parse(options.at(name), a) || a < low || a > high)
      throw InputError("option " + name + " = '" + options.at(name) + "' must be in [" +
                       text(low) + ", " + text(high) + "]");
    return a;
  }
  bool on(const string& name) const {
    const string& a = options.at(name);
    if (a != "on" && a != "off") throw InputError(name + " = '" + a + "': on or off");
    return a == "on";
  }
  /// Parameters for a state: its radii, and what the command says.
  Parameters parameters(const State& s) const {
    tinydem::vector<Setting> all{{"Rmin", text(real(s.Rmin)), "state"},
                                 {"Rmax", text(real(s.Rmax)), "state"}};
    all.insert(all.end(), settings.begin(), settings.end());
    return resolve(all);
  }
};
void print(const string& name, double value, const string& unit) {
  std::printf("%s,%.9g,%s\n", name.c_str(), value, unit.c_str());
}
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double median(tinydem::vector<double> a) {
  std::sort(a.begin(), a.end());
  return (a[(a.size() - 1) / 2] + a[a.size() / 2]) / 2;
}

// ------------------------------------------------------------------------------------- settling

/// Kinetic energy over the sum of m |g| R: 1 is a fall by about a radius.
double unrest(const Simulation& s) {
  const Summary e = s.summary();
  real scale = 0;
  for (const Grain& g : s.grains) scale += norm(s.p.g) * g.R / g.m_inv;
  return double((e.kinetic + e.rotational) / scale);
}
/// Runs until the kinetic energy is a thousandth of what a fall by a radius gives; without gravity
/// for a hundred steps. `steps` limits it.
void settle(State state, const Command& c, const string& path) {
  Simulation s(c.parameters(state), walls(c.options.at("mesh"), state), state.particles);
  const bool falls = norm(s.p.g) > 0;
  const long most = falls ? c.whole("steps", 0, 1e9) : 100, chunk = 100;
  while (s.steps < most) {
    s.run(std::min(chunk, most - s.steps));
    if (falls && s.steps >= 20 * chunk / 4 && unrest(s) < 1e-3) break;
  }
  state.particles = s.particles(), state.steps = double(s.steps);
  state.unrest = falls ? unrest(s) : 0;
  write(path, state);
  print("particles", s.size(), "1");
  print("steps", state.steps, "1");
  print("unrest", state.unrest, "m g R");
}
void stack(const State& block, int N, const Command& c, const string& path) {
  settle(stacked(block, N, int(c.whole("across", 0, 100))), c, path);
}

// --------------------------------------------------------------------------------------- timing

double pairs(const Simulation& s) {
  size_t n = 0;
  for (const Slab& b : s.slabs) n += b.pairs.size();
  return double(n);
}
double wall_contacts(const Simulation& s) {
  const auto all = s.contacts();
  return double(std::count_if(all.begin(), all.end(), [](auto& c) { return c.element >= 0; }));
}
/// What happened in a number of steps. Runs are the same bits each time, so the k-th block of steps
/// is the same work in every repetition, and its lowest time is the one that was disturbed least.
struct Timing {
  tinydem::vector<double> blocks;  // seconds
  double horizon = 0;
  long rebuilds = 0;
  void run(Simulation& s, long steps) {
    const double start = now();
    s.run(steps);
    blocks.push_back(now() - start);
  }
};
/// Steps with the solver's own horizon, in at most 200 blocks (LAMMPS gets the same ones).
Timing plain(Simulation& s, long steps) {
  const long before = s.rebuilds, block = (steps + 199) / 200;
  Timing t;
  for (long k = 0; k < steps; k += block) t.run(s, std::min(block, steps - k));
  t.horizon = double(s.horizon), t.rebuilds = s.rebuilds - before;
  return t;
}
/// Steps one by one; those in which a list is built are not counted.
Timing without_lists(Simulation& s, long steps) {
  Timing t;
  while (count(t.blocks) < steps) {
    const long before = s.rebuilds;
    t.run(s, 1);
    if (s.rebuilds > before) t.blocks.pop_back();
  }
  return t;
}
/// Steps one by one; with h > 0 the horizon is put back to h before each of them. Sorting changes
/// it by a tenth up or down and then uses it, so what was used is averaged over the lists.
Timing held(Simulation& s, long steps, real h) {
  Timing t;
  for (long k = 0; k < steps; ++k) {
    const long before = s.rebuilds;
    if (h > 0) s.horizon = h;
    t.run(s, 1);
    if (s.rebuilds > before) ++t.rebuilds, t.horizon += double(s.horizon);
  }
  t.horizon = t.rebuilds > 0 ? t.horizon / double(t.rebuilds) : double(s.horizon);
  return t;
}
void time(const State& state, const Command& c) {
  const long steps = c.whole("steps", 1, 1e9), warm = c.whole("warm", 0, 1e9);
  const bool hold = !c.options.at("horizon").empty();
  const bool lists = c.on("lists"), spins = c.on("spins");
  const real h = hold ? c.number("horizon", 0, 20) : 0;
  const Mesh mesh = walls(c.options.at("mesh"), state);
  auto particles = state.particles;
  if (!spins) for (Particle& a : particles) a.w = {};
  tinydem::vector<double> ns, lowest(size_t(steps), HUGE_VAL);
  for (long k = c.whole("repeats", 1, 1e6); k-- > 0;) {
    Simulation s(c.parameters(state), mesh, particles);
    if (hold) held(s, warm, h);
    else s.run(warm);
    const Timing t = hold ? held(s, steps, h) : lists ? plain(s, steps)
                                             : without_lists(s, steps);
    const double N = s.size(), scale = 1e9 / double(steps) / N;
    ns.push_back(scale * std::accumulate(t.blocks.begin(), t.blocks.end(), 0.));
    lowest.resize(t.blocks.size());
    for (size_t b = 0; b < lowest.size(); ++b) lowest[b] = std::min(lowest[b], scale * t.blocks[b]);
    if (k > 0) continue;
    const double contacts = double(s.summary().contacts);
    print("time", median(ns), "ns");
    std::printf("blocks");  // their parts of the time, separated by blanks
    for (const double& b : lowest) std::printf("%c%.9g", &b == &lowest[0] ? ',' : ' ', b);
    std::printf(",ns\n");
    print("contacts", contacts / N, "1");
    print("wall_contacts", wall_contacts(s) / N, "1");
    print("pairs", pairs(s) / N, "1");
    print("rebuilds", 1000 * double(t.rebuilds) / double(steps), "per 1000 steps");
    print("horizon", t.horizon, "1");
    if (norm(s.p.g) > 0) print("unrest", unrest(s), "m g R");
  }
}

// --------------------------------------------------------------------------------------- memory

/// A line of /proc/self/status [bytes]: VmHWM, the most memory that this process had; VmRSS, what
/// it has now. (getrusage would also tell of the process that started this one.)
double status(const string& name) {
  std::ifstream file("/proc/self/status");
  for (string line; std::getline(file, line);)
    if (line.rfind(name + ":", 0) == 0) return 1024 * std::stod(line.substr(name.size() + 1));
  throw RunError("/proc/self/status: is needed to measure memory, and only Linux has it");
}
void memory(const string& path, const Command& c) {
  const double empty_peak = status("VmHWM"), empty = status("VmRSS");
  State state = read(path);
  Simulation s(c.parameters(state), walls(c.options.at("mesh"), state), state.particles);
  state.particles = {};
  const double N = s.size(), loaded = status("VmHWM");
  s.run(c.whole("steps", 1, 1e9));
  const long rebuilds = s.rebuilds;
  for (s.stale = true; s.rebuilds < rebuilds + 2; s.stale = true) s.run(1);  // two more lists
  print("peak", (status("VmHWM") - empty_peak) / N, "bytes");
  print("peak_loading", (loaded - empty_peak) / N, "bytes");
  print("resident", (status("VmRSS") - empty) / N, "bytes");
  print("grain", sizeof(Grain), "bytes");
  print("pair", sizeof(Pair), "bytes");
  print("springs", sizeof(Springs<real>), "bytes");
  print("pairs", pairs(s) / N, "1");
}

// ----------------------------------------------------------------------------------------- main

int particles(const string& word) {
  real n = 0;
  if (!parse(word, n) || n < 1 || n > real(1e8) || n != std::floor(n))
    throw InputError("number of particles '" + word + "' must be an integer in [1, 1e8]");
  return int(n);
}
void run(const tinydem::vector<string>& words) {
  const string verb = words.empty() ? "" : words[0];
  const auto need = [&](int n) {
    if (count(words) < n) throw InputError("bench " + verb + ": words are missing, see bench.cpp");
  };
  if (verb == "settle")
    need(4), settle(loose(words[1], particles(words[2])), Command(words, 4), words[3]);
  else if (verb == "stack")
    need(4), stack(read(words[1]), particles(words[2]), Command(words, 4), words[3]);
  else if (verb == "time") need(2), time(read(words[1]), Command(words, 2));
  else if (verb == "memory") need(2), memory(words[1], Command(words, 2));
  else if (verb == "has") {
    need(2);
    bool known = false;
#define X(name, ...) known |= words[1] == #name;
    TINYDEM_PARAMETERS(X)
#undef X
    print(words[1], known, "1");
  } else if (verb == "flags") std::cout << "flags," << BENCH_FLAGS << ",\n";
  else
    throw InputError("'" + verb + "' must be settle, stack, time, memory, has or flags");
}
}  // namespace bench

int main(int argc, char** argv) {
  try {
    bench::run({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    std::cerr << "error: " << e.what() << std::endl;
    return dynamic_cast<const tinydem::InputError*>(&e) ? 2 : 1;
  }
}
