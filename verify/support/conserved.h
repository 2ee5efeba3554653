// SPDX-License-Identifier: MIT
// An attribute class of an application.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/attribute.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dsc::test {

/// A conserved quantity of triangles: divided in proportion to area if a triangle is cut or two are
/// flipped, and given to neighbours if one vanishes.
class Conserved final : public AttributeBase {
public:
    explicit Conserved(std::string name) : AttributeBase(std::move(name), SimplexKind::triangle) {}

    double& operator[](Triangle t) { return values_[t.id]; }

    [[nodiscard]] std::size_t size() const override { return values_.size(); }
    void resize(std::size_t size) override { values_.resize(size, 0); }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone_empty() const override {
        return std::make_unique<Conserved>(name());
    }
    void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) override {
        for (const std::uint32_t entry : order) {
            values_.push_back(entry == no_id ? 0
                                             : static_cast<const Conserved&>(from).values_[entry]);
        }
    }
    void swap_entries(AttributeBase& other) noexcept override {
        values_.swap(static_cast<Conserved&>(other).values_);
    }
    void copy(std::uint32_t to, std::uint32_t from) override { values_[to] = values_[from]; }
    void reset(std::uint32_t to) override { values_[to] = 0; }

    void split(std::uint32_t to, std::uint32_t from, double share) override {
        values_[to] = share * values_[from];
        values_[from] -= values_[to];
    }
    void merge(std::uint32_t into, std::uint32_t gone) override { values_[into] += values_[gone]; }
    void flip(std::uint32_t one, std::uint32_t other, double share) override {
        const double both = values_[one] + values_[other];
        values_[one] = share * both;
        values_[other] = both - values_[one];
    }

private:
    std::vector<double> values_;
};

} // namespace dsc::test
