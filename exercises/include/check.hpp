// The part of the grader that runs next to an answer. It evaluates the functions of the answer on
// the numbers that the grader sends, and sends back what they return. It knows nothing else: no
// expected value, no score.
//
// A checks.cpp is a list of functions (see AUTHORING.md):
//
//   #include "check.hpp"
//   #include "exercise.hpp"
//   int main(int, char** a) { return check::serve(a, {check::function("force", force)}); }
//
// Arguments and results are numbers, or structs and arrays of double. What a function does to an
// argument that it takes by reference (T&) is sent back after its result. A function of
// const std::vector<double>& that returns a std::vector<double> may take and give any length.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace check {

using Numbers = std::vector<double>;

/// How many doubles stand for a T.
template <class T> constexpr std::size_t width() {
  if constexpr (std::is_void_v<T>) return 0;
  else if constexpr (std::is_arithmetic_v<T>) return 1;
  else {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0,
                  "arguments and results are numbers, or structs and arrays of double");
    return sizeof(T) / sizeof(double);
  }
}
/// Takes a T from the numbers at `from` and moves on.
template <class T> T take(const double*& from) {
  T value{};
  if constexpr (std::is_arithmetic_v<T>) value = static_cast<T>(*from);
  else std::memcpy(static_cast<void*>(&value), from, sizeof(T));
  from += width<T>();
  return value;
}
template <class T> void give(const T& value, Numbers& to) {
  if constexpr (std::is_arithmetic_v<T>) to.push_back(static_cast<double>(value));
  else {
    double numbers[width<T>()];
    std::memcpy(numbers, &value, sizeof(T));
    to.insert(to.end(), numbers, numbers + width<T>());
  }
}
/// Sends back what an argument has become, if it is a T& and not const.
template <class A, class T> void give_back(const T& value, Numbers& to) {
  using Plain = std::remove_reference_t<A>;
  if constexpr (std::is_lvalue_reference_v<A> && !std::is_const_v<Plain>) give(value, to);
}

/// A function of the answer: `inputs` doubles in (any number if 0), doubles out.
struct Function {
  std::string name;
  std::size_t inputs;
  std::function<void(const double* in, std::size_t count, Numbers& out)> evaluate;
};

template <class R, class... A> Function function(const char* name, R (*f)(A...)) {
  const auto evaluate = [f](const double* in, std::size_t, Numbers& out) {
    std::tuple<std::decay_t<A>...> arguments{take<std::decay_t<A>>(in)...};
    if constexpr (std::is_void_v<R>) std::apply(f, arguments);
    else give(static_cast<R>(std::apply(f, arguments)), out);
    std::apply([&out](const auto&... a) { (give_back<A>(a, out), ...); }, arguments);
  };
  return {name, (width<std::decay_t<A>>() + ... + 0), evaluate};
}
inline Function function(const char* name, Numbers (*f)(const Numbers&)) {
  return {name, 0, [f](const double* in, std::size_t count, Numbers& out) {
            const Numbers result = f(Numbers(in, in + count));
            out.insert(out.end(), result.begin(), result.end());
          }};
}

// ---------------------------------------------------------------------------- the conversation

/// What the grader asks: evaluate `name` on `rows` rows of `width` numbers, which follow. The
/// answer repeats the token, so that numbers that were written by something else do not pass.
struct Request {
  std::uint64_t token, rows, width;
  char name[40];
};
/// status: 0 evaluated, 1 no such function, 2 wrong width. rows * width numbers follow.
struct Reply {
  std::uint64_t token, status, rows, width;
};

/// Reads or writes all bytes; false when the other end is gone.
template <class F, class P> bool all(F transfer, int file, P* bytes, std::size_t count) {
  while (count > 0) {
    const auto done = transfer(file, bytes, count);
    if (done <= 0) return false;
    bytes += done, count -= static_cast<std::size_t>(done);
  }
  return true;
}
inline bool receive(int file, void* to, std::size_t count) {
  return all(::read, file, static_cast<char*>(to), count);
}
inline bool send(int file, const void* from, std::size_t count) {
  return all(::write, file, static_cast<const char*>(from), count);
}

inline Reply evaluate(const Request& q, const Function* f, const Numbers& in, Numbers& out) {
  if (f == nullptr) return {q.token, 1, 0, 0};
  if (f->inputs != 0 && f->inputs != q.width) return {q.token, 2, 0, 0};
  for (std::size_t k = 0; k < q.rows; ++k) f->evaluate(in.data() + k * q.width, q.width, out);
  return {q.token, 0, q.rows, q.rows > 0 ? out.size() / q.rows : 0};
}

/// Answers requests until there are no more. a: the arguments of main(), that is, the numbers of
/// the files to read from and to write to.
inline int serve(char** a, const std::vector<Function>& functions) {
  const int in = std::atoi(a[1]), out = std::atoi(a[2]);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // what an answer prints is not lost when it crashes
  for (Request q; receive(in, &q, sizeof q);) {
    Numbers rows(q.rows * q.width), results;
    if (!receive(in, rows.data(), rows.size() * sizeof(double))) return 1;
    const Function* chosen = nullptr;
    for (const Function& f : functions) if (f.name == q.name) chosen = &f;
    const Reply reply = evaluate(q, chosen, rows, results);
    if (!send(out, &reply, sizeof reply)) return 1;
    if (!send(out, results.data(), results.size() * sizeof(double))) return 1;
  }
  return 0;
}

}  // namespace check
