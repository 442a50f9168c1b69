// The linear equations of an implicit step.
#pragma once

#include <Eigen/SparseLU>

#include "integrators/system.hpp"

namespace sulfur::lab {

/// Solves (I - h da/dv - h^2 da/dx) out = right. The matrix of a chain, in which particles depend
/// on their neighbours in order only, is block tridiagonal: one elimination from end to end
/// (Thomas). Any other goes to a sparse LU decomposition.
class ImplicitMatrix {
public:
    void solve(const Jacobian& jacobian, double h, const Vecs& right, Vecs& out);

private:
    void solveChain(const Jacobian& jacobian, double h, Vecs& out);
    void solveSparse(const Jacobian& jacobian, double h, Vecs& out);

    std::vector<Mat> before_, self_, behind_;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
};

}  // namespace sulfur::lab
