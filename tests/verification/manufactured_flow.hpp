#pragma once
/// A smooth unsteady flow that meets the boundary conditions, and the force that drives it.
#include <vector>

#include "grid/field.hpp"

namespace starling::support {

/// offset + slope s + amplitude cos(k s + phase), with all its derivatives.
struct Factor {
    Real offset = 0, slope = 0, amplitude = 0, k = 0, phase = 0;

    Real operator()(int derivative, Real s) const
    {
        const Real line = derivative == 0 ? offset + slope * s : derivative == 1 ? slope : 0;
        return line +
               amplitude * std::pow(k, derivative) * std::cos(k * s + phase + derivative * pi / 2);
    }
};

/// coefficient X^(order_x)(x) Y^(order_y)(y) Z^(order_z)(z).
struct Product {
    Real coefficient;
    Factor X, Y, Z;
    std::array<int, 3> order{};

    Real operator()(const Vec3& r, std::array<int, 3> d) const
    {
        return coefficient * X(order[0] + d[0], r.x) * Y(order[1] + d[1], r.y) *
               Z(order[2] + d[2], r.z);
    }
};

/// Sum of products; f(r, {1, 0, 0}) is its x-derivative.
struct SmoothFunction {
    std::vector<Product> terms;

    Real operator()(const Vec3& r, std::array<int, 3> derivative = {0, 0, 0}) const
    {
        Real sum = 0;
        for (const Product& p : terms) sum += p(r, derivative);
        return sum;
    }
};

/// u = T(t) U(x), P = S(t) Q(x): div U = 0, zero normal derivative of U and Q = 0 on the end
/// faces, U = 0 and zero normal derivative of Q on the y walls, periodic in z. With
/// f' = sin^2(pi x/L), q = sin^2(pi y/W_y), h = sin(2 pi z/W_z):
/// U = (f q' + f h' q, -f' q, -f' h q), Q = sin(pi x/L) cos(pi y/W_y) (1 + h/2).
class ManufacturedFlow {
public:
    Vec3 lengths{2, 1.5, 1.8}; ///< the box begins at the origin
    Real reynolds = 10;
    bool steady = false;

    explicit ManufacturedFlow(Real Re = 10, bool is_steady = false)
        : reynolds(Re), steady(is_steady)
    {
        const Real a = pi / lengths.x, b = pi / lengths.y, c = 2 * pi / lengths.z;
        const Factor f{0, 0.5, -0.25 / a, 2 * a, -pi / 2}; // x/2 - sin(2 a x)/(4 a)
        const Factor q{0.5, 0, -0.5, 2 * b, 0}, h{0, 0, 1, c, -pi / 2}, one{1, 0, 0, 0, 0};
        velocity_ = {SmoothFunction{{{1, f, q, one, {0, 1, 0}}, {1, f, q, h, {0, 0, 1}}}},
                     SmoothFunction{{{-1, f, q, one, {1, 0, 0}}}},
                     SmoothFunction{{{-1, f, q, h, {1, 0, 0}}}}};
        const Factor sine{0, 0, 1, a, -pi / 2}, cosine{0, 0, 1, b, 0};
        pressure_ = {{{1, sine, cosine, Factor{1, 0, 0.5, c, -pi / 2}}}};
    }

    Grid grid(std::array<Index, 3> cells) const { return Grid(cells, {0, 0, 0}, lengths); }
    Real T(Real t) const { return steady ? 1 : 1 + 0.5 * std::sin(4 * t); }
    Real dT_dt(Real t) const { return steady ? 0 : 2 * std::cos(4 * t); }
    Real S(Real t) const { return steady ? 1 : 1 + 0.5 * std::cos(3 * t); }

    Real U(Location c, const Vec3& r) const { return component(c)(r); }
    Real Q(const Vec3& r) const { return pressure_(r); }
    /// div(U U), Lap U and grad Q, component c.
    Real advection(Location c, const Vec3& r) const
    {
        Real sum = 0;
        for (Location d : components) sum += U(d, r) * component(c)(r, along(d, 1));
        return sum;
    }
    Real laplacian(Location c, const Vec3& r) const
    {
        Real sum = 0;
        for (Location d : components) sum += component(c)(r, along(d, 2));
        return sum;
    }
    Real gradient(Location c, const Vec3& r) const { return pressure_(r, along(c, 1)); }

private:
    const SmoothFunction& component(Location c) const
    {
        return velocity_[static_cast<std::size_t>(axis(c))];
    }
    static std::array<int, 3> along(Location d, int order)
    {
        std::array<int, 3> derivative{};
        derivative[static_cast<std::size_t>(axis(d))] = order;
        return derivative;
    }

    std::array<SmoothFunction, 3> velocity_;
    SmoothFunction pressure_;
};

/// The force F = u_t + div(u u) + grad P - Lap u/Re at the faces of a grid, at any time: the parts
/// that depend on the place are evaluated once.
class ManufacturedForce {
public:
    ManufacturedForce(const ManufacturedFlow& flow, const Grid& g)
        : flow_(flow), grid_(g), U_(g), N_(g), L_(g), G_(g)
    {
        for (Location c : components) {
            const View<Real> U = U_[c].view(), N = N_[c].view(), L = L_[c].view(), G = G_[c].view();
            for_each(g.unknowns(c), [=, &flow, &g](Index i, Index j, Index k) {
                const Vec3 r = g.position(c, i, j, k);
                U(i, j, k) = flow.U(c, r);
                N(i, j, k) = flow.advection(c, r);
                L(i, j, k) = flow.laplacian(c, r);
                G(i, j, k) = flow.gradient(c, r);
            });
        }
    }
    void evaluate(Real t, VectorField& F) const
    {
        const Real T = flow_.T(t), dT = flow_.dT_dt(t), S = flow_.S(t), nu = 1 / flow_.reynolds;
        for (Location c : components) {
            const View<const Real> U = U_[c].view(), N = N_[c].view(), L = L_[c].view(),
                                   G = G_[c].view();
            const View<Real> f = F[c].view();
            for_each(grid_.unknowns(c), [=](Index i, Index j, Index k) {
                f(i, j, k) =
                    dT * U(i, j, k) + T * T * N(i, j, k) + S * G(i, j, k) - nu * T * L(i, j, k);
            });
        }
    }

private:
    ManufacturedFlow flow_;
    Grid grid_;
    VectorField U_, N_, L_, G_;
};

} // namespace starling::support
