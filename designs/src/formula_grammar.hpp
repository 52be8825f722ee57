/// The grammar of formulas: what people mean, which is less than what the parser takes.
#pragma once

#include <string>

#include "study_parts.hpp"

namespace parapet::designs {

/// What a formula holds beyond the grammar, with the character's number counted from 1; empty
/// problem when it follows it:
///
///     formula    = condition "?" formula ":" formula | or
///     or         = and { "||" and }              and = comparison { "&&" comparison }
///     comparison = sum [ ("<" | ">" | "<=" | ">=" | "==" | "!=") sum ]
///     sum        = product { ("+" | "-") product }
///     product    = sign { ("*" | "/") sign }     sign = { "+" | "-" } power
///     power      = atom [ "^" sign ]
///     atom       = number | name | name "(" formula { "," formula } ")" | "(" formula ")"
///
/// A formula as a whole is a number and a condition is a comparison; neither stands for the other.
/// Commas only separate the arguments of a function, and never stand between two digits.
ExpressionProblem grammar_problem(const std::string& formula);

}  // namespace parapet::designs
