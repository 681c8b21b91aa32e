#pragma once
/// Fields on the grid with one layer of halo, and the views kernels work on.
#include "core/array.hpp"
#include "grid/grid.hpp"

namespace starling {

/// Cheap handle to a field: f(i, j, k) with i in [-1, nx+1], j in [-1, ny], k in [-1, nz].
template <class T>
struct View {
    T* data = nullptr; ///< node (0, 0, 0)
    Index stride_x = 0, stride_y = 0;

    T& operator()(Index i, Index j, Index k) const { return data[i * stride_x + j * stride_y + k]; }
    Index offset(Index i, Index j, Index k) const { return i * stride_x + j * stride_y + k; }
    /// Distance in memory to the next node along direction 0, 1, 2.
    Index stride(int direction) const
    {
        return direction == 0 ? stride_x : direction == 1 ? stride_y : 1;
    }
    operator View<const T>() const { return {data, stride_x, stride_y}; }
};

/// A field at some location of a grid; every location has the same shape in memory.
template <class T>
class Field {
public:
    Field() = default;
    explicit Field(const Grid& g)
        : stride_y_(g.nz() + 2), stride_x_((g.ny() + 2) * (g.nz() + 2)),
          values_((g.nx() + 3) * stride_x_)
    {
    }

    View<T> view() { return {values_.data() + origin(), stride_x_, stride_y_}; }
    View<const T> view() const { return {values_.data() + origin(), stride_x_, stride_y_}; }
    T& operator()(Index i, Index j, Index k) { return view()(i, j, k); }
    const T& operator()(Index i, Index j, Index k) const { return view()(i, j, k); }
    void fill(T value) { values_.fill(value); }
    /// All values with halos, for checkpoints.
    Array<T>& values() { return values_; }
    const Array<T>& values() const { return values_; }

private:
    Index origin() const { return stride_x_ + stride_y_ + 1; }

    Index stride_y_ = 0, stride_x_ = 0;
    Array<T> values_;
};

using ScalarField = Field<Real>;

/// Three components, each at its own face.
struct VectorField {
    std::array<ScalarField, 3> component;

    VectorField() = default;
    explicit VectorField(const Grid& g) : component{ScalarField(g), ScalarField(g), ScalarField(g)}
    {
    }
    ScalarField& operator[](Location c) { return component[static_cast<std::size_t>(axis(c))]; }
    const ScalarField& operator[](Location c) const
    {
        return component[static_cast<std::size_t>(axis(c))];
    }
};

} // namespace starling
