// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MomentBounds.h"

#include <glpk.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace
{
constexpr double HalfTurn = 3.14159265358979323846;

// To both sides of a depth, and how much nearer to each other they are after each round: 2e-7 after the last.
constexpr int Angles = 256;
constexpr int Refinement = 8;
constexpr int Rounds = 5;

/// Of a polynomial of x, from the 0th on.
using Coefficients = std::vector<double>;

/// A depth x is the angle of which x - z is the tangent, where z is the depth in question: -pi/2 and pi/2 are infinity.
/// What masses w make of a polynomial P(x) of degree n, the sum of w P(x), is also that of (w / cos(angle)^n) times
/// P(x) cos(angle)^n: both factors stay finite at infinity. Two distributions have the same moments if these
/// polynomials have the same sums: the real and the imaginary part of (1 + i (x - z))^(n/2 + j) (1 - i (x - z))^(n/2 -
/// j), j from 0 to n / 2. Times cos(angle)^n they are 1, and cosine and sine of 2 j angle, which are as different as
/// can be; with powers the solver finds no solution where moments leave little freedom.
std::vector<Coefficients> EquationsAbout(double z, int degree)
{
  const std::complex<double> i(0, 1);
  std::vector<Coefficients> equations;
  for (int j = 0; j <= degree / 2; ++j)
  {
    std::vector<std::complex<double>> product(1, 1.0);
    for (int factor = 0; factor < degree; ++factor)
    {
      const std::complex<double> slope = factor < degree / 2 + j ? i : -i;
      product.push_back(0);
      for (std::size_t k = product.size(); k-- > 0;)
      {
        product[k] = (1.0 - slope * z) * product[k] + (k > 0 ? slope * product[k - 1] : 0.0);
      }
    }
    Coefficients real;
    Coefficients imaginary;
    for (const std::complex<double>& coefficient : product)
    {
      real.push_back(coefficient.real());
      imaginary.push_back(coefficient.imag());
    }
    equations.push_back(real);
    if (j > 0)
    {
      equations.push_back(imaginary);
    }
  }
  return equations;
}

/// Masses over cos(angle)^n are the unknowns.
class Program
{
public:
  /// direction: GLP_MIN, of what is at angles below 0, or GLP_MAX, of what is at 0, too.
  Program(const std::vector<double>& sums, int direction)
    : Degree(static_cast<int>(sums.size()) - 1)
    , Direction(direction)
  {
    glp_set_obj_dir(this->Problem.get(), direction);
    for (double sum : sums)
    {
      const int row = glp_add_rows(this->Problem.get(), 1);
      glp_set_row_bnds(this->Problem.get(), row, GLP_FX, sum, sum);
    }
  }

  /// Unknown masses at these angles, unless there are such.
  void Add(const std::set<double>& angles)
  {
    for (double angle : angles)
    {
      if (std::abs(angle) <= HalfTurn / 2 && this->Known.insert(angle).second)
      {
        this->Add(angle);
      }
    }
  }

  void Solve()
  {
    glp_smcp parameters;
    glp_init_smcp(&parameters);
    parameters.msg_lev = GLP_MSG_OFF;
    parameters.it_lim = 1000;
    // Moments that leave hardly any freedom may leave none to a solver that rounds: less exactly, then, and in the end
    // by rational numbers, which takes a thousand times as long.
    for (double tolerance : { 1e-10, 1e-9, 1e-8, 1e-7 })
    {
      parameters.tol_bnd = tolerance;
      parameters.tol_dj = tolerance;
      if (glp_simplex(this->Problem.get(), &parameters) == 0 && this->IsSolved())
      {
        return;
      }
    }
    if (glp_exact(this->Problem.get(), &parameters) != 0 || !this->IsSolved())
    {
      throw std::runtime_error("GLPK has no optimum, status " + std::to_string(glp_get_status(this->Problem.get())));
    }
  }

  double GetOptimum() const { return glp_get_obj_val(this->Problem.get()); }

  /// How the optimum changes with each sum.
  double GetSlope(int equation) const { return glp_get_row_dual(this->Problem.get(), equation + 1); }

  /// Around those that have mass.
  std::set<double> GetNearerAngles(double step) const
  {
    std::set<double> nearer;
    for (std::size_t column = 0; column < this->Columns.size(); ++column)
    {
      if (glp_get_col_stat(this->Problem.get(), static_cast<int>(column) + 1) == GLP_BS)
      {
        for (int i = -Refinement; i <= Refinement; ++i)
        {
          nearer.insert(this->Columns[column] + i * step);
        }
      }
    }
    return nearer;
  }

private:
  bool IsSolved() const { return glp_get_status(this->Problem.get()) == GLP_OPT; }

  void Add(double angle)
  {
    this->Columns.push_back(angle);
    const int column = glp_add_cols(this->Problem.get(), 1);
    glp_set_col_bnds(this->Problem.get(), column, GLP_LO, 0, 0);
    std::vector<int> rows{ 0, 1 }; // GLPK counts from 1
    std::vector<double> values{ 0, 1 };
    for (int j = 1; j <= this->Degree / 2; ++j)
    {
      rows.insert(rows.end(), { 2 * j, 2 * j + 1 });
      values.insert(values.end(), { std::cos(2 * j * angle), std::sin(2 * j * angle) });
    }
    glp_set_mat_col(this->Problem.get(), column, this->Degree + 1, rows.data(), values.data());
    const bool isInFront = this->Direction == GLP_MIN ? angle < 0 : angle <= 0;
    glp_set_obj_coef(this->Problem.get(), column, isInFront ? std::pow(std::cos(angle), this->Degree) : 0);
  }

  std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> Problem{ glp_create_prob(), glp_delete_prob };
  int Degree;
  int Direction;
  std::vector<double> Columns; // their angles
  std::set<double> Known;
};

MomentBound Extreme(const std::vector<double>& moments, const std::vector<double>& depths, double depth, int direction)
{
  const std::vector<Coefficients> equations = EquationsAbout(depth, static_cast<int>(moments.size()) - 1);
  std::vector<double> sums;
  for (const Coefficients& equation : equations)
  {
    sums.push_back(std::inner_product(equation.begin(), equation.end(), moments.begin(), 0.0));
  }
  double step = HalfTurn / 2 / Angles;
  std::set<double> angles;
  for (int i = 1 - Angles; i <= Angles; ++i)
  {
    angles.insert(i * step);
  }
  for (double other : depths)
  {
    angles.insert(std::atan(other - depth));
  }
  Program program(sums, direction);
  program.Add(angles);
  program.Solve();
  for (int round = 0; round < Rounds; ++round)
  {
    step /= Refinement;
    program.Add(program.GetNearerAngles(step));
    program.Solve();
  }
  MomentBound bound{ program.GetOptimum(), std::vector<double>(moments.size()) };
  for (std::size_t row = 0; row < equations.size(); ++row)
  {
    for (std::size_t k = 0; k < moments.size(); ++k)
    {
      bound.Slopes[k] += program.GetSlope(static_cast<int>(row)) * equations[row][k];
    }
  }
  return bound;
}
}

MomentBound LeastInFront(const std::vector<double>& moments, const std::vector<double>& depths, double depth)
{
  return Extreme(moments, depths, depth, GLP_MIN);
}

MomentBound MostUpTo(const std::vector<double>& moments, const std::vector<double>& depths, double depth)
{
  return Extreme(moments, depths, depth, GLP_MAX);
}
