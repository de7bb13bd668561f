// Exercise 15: runs the tests of the answer with one of the solvers. The solvers are one program; the
// number of the one that runs is a variable whose name (BROKEN) no answer knows.
#include "check.hpp"
#include "exercise.hpp"

extern int BROKEN;

namespace {

struct Test {
  std::string name;
  std::function<void()> run;
};
std::vector<Test>& tests() {
  static std::vector<Test> all;
  return all;
}
std::string failure;  // of the test that runs, the first one
long expectations = 0;

void fail(const std::string& why) {
  if (failure.empty()) failure = why;
}

/// (number of the solver) -> tests, those that fail, expectations; then name and reason of the first.
std::vector<double> run_tests(const std::vector<double>& in) {
  BROKEN = static_cast<int>(in[0]);
  std::string said;
  double failed = 0;
  expectations = 0;
  for (const Test& t : tests()) {
    failure.clear();
    const long before = expectations;
    try {
      t.run();
    } catch (const std::exception& e) {
      ++expectations, fail(std::string("stopped: ") + e.what());
    } catch (...) {
      ++expectations, fail("stopped by an exception");
    }
    if (expectations == before) fail("expects nothing");
    if (!failure.empty() && ++failed == 1) said = t.name + ": " + failure;
  }
  BROKEN = 0;
  std::vector<double> out = {double(tests().size()), failed, double(expectations)};
  for (const char c : said.substr(0, 300)) out.push_back(static_cast<unsigned char>(c));
  return out;
}

}  // namespace

bool list_test(const std::string& name, const std::function<void()>& test) {
  tests().push_back({name, test});
  return true;
}
void expect(const std::string& what, double measured, double expected, double tolerance) {
  ++expectations;
  if (std::abs(measured - expected) <= tolerance) return;
  fail(what + " is " + tinydem::text(measured, 6) + ", not " + tinydem::text(expected, 6) +
       " within " + tinydem::text(tolerance, 3));
}
void expect(const std::string& what, bool condition) {
  ++expectations;
  if (!condition) fail("not true: " + what);
}

int main(int, char** files) {
  return check::serve(files, {check::function("run_tests", run_tests)});
}
