// What the caller says about contacts before they are solved.
#pragma once

#include <vector>

namespace sulfur::detail {

struct State;
struct Pair;
struct Passing;

/// Rows that do not act in this step go, others take up what the caller has made of their surfaces.
void askAboutRows(State& state);
/// Rows have their own surfaces again.
void forgetAnswers(State& state);
/// Of what would pass through each other, whatever may do so goes.
void askAboutPassings(State& state, const Pair& pair, std::vector<Passing>& passings);

}  // namespace sulfur::detail
