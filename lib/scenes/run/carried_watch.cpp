// SPDX-License-Identifier: MIT
#include "scenes/run/carried_watch.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr const char* triangle_numbers = "scenes.carried_triangle";
constexpr const char* vertex_numbers = "scenes.carried_vertex";

/// The numbers of the triangles watched, from 1 on; 0 for all others. Counts what happens to them,
/// from several threads at once.
class WatchedTriangles final : public AttributeBase {
public:
    explicit WatchedTriangles(std::shared_ptr<std::atomic<std::uint64_t>> operations)
        : AttributeBase(triangle_numbers, SimplexKind::triangle),
          operations_(std::move(operations)) {}

    [[nodiscard]] std::uint32_t& operator[](Triangle t) { return data_[t.id]; }

    [[nodiscard]] std::size_t size() const override { return data_.size(); }
    void resize(std::size_t size) override { data_.resize(size, 0); }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone_empty() const override {
        return std::make_unique<WatchedTriangles>(operations_);
    }
    void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) override {
        const auto& data = dynamic_cast<const WatchedTriangles&>(from).data_;
        for (const std::uint32_t i : order) {
            data_.push_back(i == no_id ? 0 : data[i]);
        }
    }
    void swap_entries(AttributeBase& other) noexcept override {
        data_.swap(static_cast<WatchedTriangles&>(other).data_);
    }
    void archive(Archive& archive) override { archive(data_); }
    void copy(std::uint32_t to, std::uint32_t from) override { data_[to] = data_[from]; }
    void reset(std::uint32_t to) override { data_[to] = 0; }
    void split(std::uint32_t to, std::uint32_t from, double /*share*/) override {
        data_[to] = 0;
        count(data_[from] != 0);
    }
    void merge(std::uint32_t /*into*/, std::uint32_t gone) override { count(data_[gone] != 0); }
    void flip(std::uint32_t one, std::uint32_t other, double /*share*/) override {
        count(data_[one] != 0 || data_[other] != 0);
    }

private:
    void count(bool is_watched) { *operations_ += is_watched ? 1 : 0; }

    std::shared_ptr<std::atomic<std::uint64_t>> operations_;
    std::vector<std::uint32_t> data_;
};

} // namespace

template <class Real>
CarriedWatch<Real>::CarriedWatch(Complex<Real>& complex, std::vector<Phase> phases)
    : complex_(complex), phases_(std::move(phases)),
      operations_(std::make_shared<std::atomic<std::uint64_t>>(0)) {
    auto& vertex_number = complex.attributes.template add<Vertex, std::uint32_t>(
        vertex_numbers, 0, [](std::uint32_t, std::uint32_t, double) { return std::uint32_t{0}; });
    for (const Vertex v : vertices(complex)) {
        vertex_number[v] = v.id + 1;
    }
    auto& number = complex.attributes.add(std::make_unique<WatchedTriangles>(operations_));
    for (const Triangle t : dsc::triangles(complex)) {
        if (is_inside(t)) {
            first_.push_back(known(t));
            number[t] = static_cast<std::uint32_t>(first_.size());
        }
    }
    figures_.triangles = first_.size();
}

template <class Real>
bool CarriedWatch<Real>::is_inside(Triangle t) const {
    return std::ranges::find(phases_, complex_.phase(t)) != phases_.end();
}

template <class Real>
typename CarriedWatch<Real>::Known CarriedWatch<Real>::known(Triangle t) const {
    const auto& number =
        std::as_const(complex_.attributes).template get<Vertex, std::uint32_t>(vertex_numbers);
    std::array<Vertex, 3> v = complex_.vertices_of(t);
    const auto by_number = [&](Vertex a, Vertex b) { return number[a] < number[b]; };
    std::rotate(v.begin(), std::min_element(v.begin(), v.end(), by_number), v.end());
    Known triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.v[i] = number[v[i]];
        triangle.lengths[i] = static_cast<double>(
            (complex_.position(v[(i + 1) % 3]) - complex_.position(v[i])).norm());
    }
    return triangle;
}

template <class Real>
const CarriedFigures& CarriedWatch<Real>::look() {
    auto& number = complex_.attributes.template get<WatchedTriangles>(triangle_numbers);
    std::uint64_t same = 0;
    std::uint64_t inside = 0;
    for (const Triangle t : dsc::triangles(complex_)) {
        if (!is_inside(t)) {
            continue;
        }
        ++inside;
        const std::uint32_t which = number[t];
        if (which == 0) {
            continue;
        }
        const Known& first = first_[which - 1];
        const Known now = known(t);
        if (now.v != first.v) {
            continue;
        }
        ++same;
        for (std::size_t i = 0; i < 3; ++i) {
            figures_.edge_change =
                std::max(figures_.edge_change, std::abs(now.lengths[i] / first.lengths[i] - 1));
        }
    }
    figures_.triangles_changed =
        std::max(figures_.triangles_changed, std::max(inside, figures_.triangles) - same);
    figures_.operations = *operations_;
    return figures_;
}

template <class Real>
void CarriedWatch<Real>::archive(Archive& archive) {
    std::uint64_t operations = *operations_;
    archive(operations, figures_.triangles_changed, figures_.edge_change);
    *operations_ = operations;
    auto& number = complex_.attributes.template get<WatchedTriangles>(triangle_numbers);
    for (const Triangle t : dsc::triangles(complex_)) {
        archive.expect(number[t] <= first_.size(), "watches a triangle that is none of its own");
    }
}

template class CarriedWatch<double>;
template class CarriedWatch<float>;

} // namespace dsc::scenes
