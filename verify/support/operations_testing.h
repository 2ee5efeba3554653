// SPDX-License-Identifier: MIT
// Common parts of the tests of operations: afterwards the complex is valid, or no byte has changed.
#pragma once

#include "snapshot.h"

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::test {

template <class Real>
void expect_valid(const Complex<Real>& complex) {
    const ValidationReport report = validate(complex);
    EXPECT_TRUE(report.ok()) << report.problem;
}

/// The submesh of the vertices with label 1; the labels must outlive it.
template <class Real>
Submesh<Real> submesh_of(Complex<Real>& complex, const std::vector<std::uint32_t>& labels) {
    Submesh<Real> submesh(complex);
    submesh.region.kind = Region::Kind::labels;
    submesh.region.labels = labels.data();
    submesh.region.label = 1;
    return submesh;
}

/// Checks that `operate(submesh)` returns that verdict and changes no byte. No labels: the whole
/// complex.
template <class Real, class Operate>
void expect_refused(Complex<Real>& complex, Verdict expected, Operate operate,
                    const std::vector<std::uint32_t>& labels = {}) {
    const std::string before = snapshot(complex);
    const Verdict verdict =
        operate(labels.empty() ? Submesh(complex) : submesh_of(complex, labels));
    EXPECT_EQ(to_string(verdict), to_string(expected));
    EXPECT_EQ(before == snapshot(complex), true) << "a refused operation changed the complex";
}

/// The verdict on a copy in which the operation may use only this many ids.
template <class Real, class Operate>
Verdict verdict_with_ids(Complex<Real> complex, std::uint32_t vertices, std::uint32_t triangles,
                         Operate operate) {
    std::vector<std::uint32_t> v(vertices);
    std::vector<std::uint32_t> t(triangles);
    for (auto& id : v) {
        id = complex.take_vertex(complex.ids);
    }
    for (auto& id : t) {
        id = complex.take_triangle(complex.ids);
    }
    for (const auto id : v) {
        complex.give_vertex(complex.ids, id);
    }
    for (const auto id : t) {
        complex.give_triangle(complex.ids, id);
    }
    complex.ids.may_grow = false;
    const std::string before = snapshot(complex);
    const Verdict verdict = operate(Submesh<Real>(complex));
    EXPECT_TRUE(verdict == Verdict::legal || before == snapshot(complex));
    expect_valid(complex);
    return verdict;
}

} // namespace dsc::test
