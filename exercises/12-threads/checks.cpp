// Exercise 12: runs the answer, by threads or in a drawn order, and watches who adds to what.
#include "check.hpp"
#include "exercise.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <random>
#include <thread>

namespace {

constexpr int most = 64;          // threads
bool watching = false;            // slow, but an answer with a race is stopped from losing numbers
unsigned order = 0;               // of the work of a team; 0: at the same time
long calls = 0;                   // of team()
thread_local int worker = -1;     // -1: outside of team()
std::mutex one_at_a_time;

/// What was seen.
struct Seen {
  std::atomic<long> evaluations[most + 1], additions[most + 1];  // by worker
  std::atomic<long> clashes;
  std::atomic<int> sphere, first, second;
  void clear() {
    for (int k = 0; k <= most; ++k) evaluations[k] = additions[k] = 0;
    clashes = 0, sphere = first = second = -1;
  }
} seen;

void work_as(int t, const std::function<void(int)>& work) {
  worker = t, work(t), worker = -1;
}

}  // namespace

Vec3 pair_force(const Packing& p, const Pair& pair) {
  if (watching) ++seen.evaluations[worker + 1];
  const Vec3 d = p.x[static_cast<std::size_t>(pair.i)] - p.x[static_cast<std::size_t>(pair.j)];
  const double distance = norm(d), delta = 2 * p.R - distance;
  if (!(delta > 0)) return {};
  return (4.0 / 3 * p.Estar * std::sqrt(p.R / 2 * delta) * delta / distance) * d;
}

Forces::Forces(int spheres)
    : sums(static_cast<std::size_t>(spheres)), writer(static_cast<std::size_t>(spheres), -1) {}

void Forces::add(int sphere, const Vec3& force) {
  const auto k = static_cast<std::size_t>(sphere);
  if (!watching) {
    sums[k] = sums[k] + force;
    return;
  }
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  sums.at(k) = sums.at(k) + force;
  ++seen.additions[worker + 1];
  const long me = calls * (most + 1) + worker, last = writer[k];
  if (worker >= 0 && last >= 0 && last / (most + 1) == calls && last != me && ++seen.clashes == 1)
    seen.sphere = sphere, seen.first = static_cast<int>(last % (most + 1)), seen.second = worker;
  if (worker >= 0) writer[k] = me;
}

void team(int threads, const std::function<void(int)>& work) {
  ++calls;
  if (order > 0) {
    std::vector<int> turn(static_cast<std::size_t>(threads));
    for (int t = 0; t < threads; ++t) turn[static_cast<std::size_t>(t)] = t;
    std::mt19937 random(order++);
    std::shuffle(turn.begin(), turn.end(), random);
    for (const int t : turn) work_as(t, work);
    return;
  }
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t) others.emplace_back(work_as, t, std::cref(work));
  work_as(0, work);
  for (std::thread& t : others) t.join();
}

struct Examiner {
  static void write(const Forces& f, std::vector<double>& out) {
    for (const Vec3& a : f.sums) check::give(a, out);
  }
};

namespace {

struct Question {
  Packing packing{};
  int threads = 1;
  /// threads, order, spheres, R, Estar, centres, i and j of every pair.
  explicit Question(const std::vector<double>& in) {
    const double* next = in.data();
    threads = check::take<int>(next), order = check::take<unsigned>(next);
    packing.x.resize(static_cast<std::size_t>(check::take<int>(next)));
    packing.R = check::take<double>(next), packing.Estar = check::take<double>(next);
    for (Vec3& x : packing.x) x = check::take<Vec3>(next);
    while (next < in.data() + in.size()) {
      const int i = check::take<int>(next);
      packing.pairs.push_back({i, check::take<int>(next)});
    }
  }
};

std::vector<double> sums_of(const std::vector<double>& in, bool watch) {
  const Question q(in);
  Forces f(static_cast<int>(q.packing.x.size()));
  watching = watch, seen.clear();
  sum_forces(q.packing, q.threads, f);
  watching = false;
  std::vector<double> out;
  Examiner::write(f, out);
  return out;
}
/// The sums.
std::vector<double> watched(const std::vector<double>& in) { return sums_of(in, true); }
std::vector<double> unwatched(const std::vector<double>& in) { return sums_of(in, false); }

/// clashes, sphere, thread, thread; evaluations and additions: of all, of the busiest thread.
std::vector<double> report(const std::vector<double>& in) {
  sums_of(in, true);
  std::vector<double> out = {double(seen.clashes), double(seen.sphere), double(seen.first),
                             double(seen.second)};
  for (const auto& by : {seen.evaluations, seen.additions}) {
    long all = 0, largest = 0;
    for (int k = 0; k <= most; ++k) all += by[k], largest = std::max(largest, by[k].load());
    out.push_back(double(all)), out.push_back(double(largest));
  }
  return out;
}

/// Seconds for one sum, the best of nine.
std::vector<double> seconds(const std::vector<double>& in) {
  const Question q(in);
  double best = 1e9;
  for (int k = 0; k < 9; ++k) {
    Forces f(static_cast<int>(q.packing.x.size()));
    const auto start = std::chrono::steady_clock::now();
    sum_forces(q.packing, q.threads, f);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return {best};
}

}  // namespace

int main(int, char** files) {
  return check::serve(files, {check::function("watched", watched),
                              check::function("unwatched", unwatched),
                              check::function("report", report),
                              check::function("seconds", seconds)});
}
