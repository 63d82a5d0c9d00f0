#pragma once

#include <vector>

#include <Eigen/Core>

namespace clevis::mechanism {

/// Cholesky of W Wᵀ for rows of W of length 1 that touch few bodies each,
/// within the skyline that this gives; and of the independent rows alone where
/// others depend on them.
class NormalCholesky {
 public:
  /// What a row has in the columns of one body.
  struct Part {
    int body = -1;
    alignas(16) double w[6];
  };
  struct Row {
    static constexpr int kMostParts = 4;  ///< of a coupling of two joints
    int count{}, last_count{};
    Part parts[kMostParts];

    Part* begin() { return parts; }
    Part* end() { return parts + count; }
    const Part* begin() const { return parts; }
    const Part* end() const { return parts + count; }
  };

  /// @param width  columns of a body, 3 or 6.
  NormalCholesky(int width, int bodies, int most_rows);

  /// Rows that follow are others than before.
  void reset(int rows);
  /// Rows follow anew, of any length, from nothing.
  void open_rows();
  /// The part of row i in the columns of a body, 0 at first.
  double* part(int i, int body);
  Row& row(int i) { return rows_of_[index(i)]; }
  /// Scales row i to length 1. @return its length, or 1 for 0.
  double close_row(int i);

  /// rows ← W v.
  void times(const Eigen::VectorXd& v, Eigen::VectorXd& rows) const;
  /// v ← v + Wᵀ factors.
  void add_rows(const Eigen::VectorXd& factors, Eigen::VectorXd& v) const;

  /// In the order of the last pivoting. @param rank  rows that are taken to be
  /// independent, the first ones. @return whether they clearly are, and the
  /// others clearly depend on them.
  bool factor_in_order(int rank);
  /// Largest pivots first. @param rank  known from elsewhere, or −1.
  /// @return false if a pivot is neither safe nor, at that rank, zero.
  bool factor_by_pivots(int rank);

  /// x ← (W Wᵀ)⁻¹ of the rows that count, by row; 0 for the others.
  void solve(const Eigen::VectorXd& rows, Eigen::VectorXd& x);

  int rank() const { return rank_; }
  double smallest_pivot() const { return smallest_pivot_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  void order_by_rows();
  void arrange();
  template <int kWidth>
  double row_times(int i, const double* v) const;
  template <int kWidth>
  void add_row(int i, double factor, double* v) const;
  template <int kWidth>
  void multiply_rows();
  double product(int i, int j) const;
  double eliminate(int i, int rank);

  int width_, rows_{}, rank_{};
  double smallest_pivot_ = 1.0;
  // pivots in the order of rows keep the skyline low, if they are safe
  bool may_sort_ = true, is_sorted_ = false, sort_next_ = false;
  long served_{};             ///< factorisations in that order
  bool is_arranged_ = false;  ///< what follows fits rows and order
  std::vector<Row> rows_of_;
  std::vector<int> order_;
  std::vector<int> first_;  ///< of the skyline, by place in the order
  /// A row's part in a body's columns.
  struct Touch {
    int place{}, row{}, part{};
  };
  struct Body {
    int begin{}, end{};  ///< of its touches, by place
  };
  std::vector<Touch> touches_;
  std::vector<Body> bodies_;
  Eigen::MatrixXd L_;  ///< Lᵀ, with the inverse of its diagonal
  Eigen::VectorXd left_, x_;
};

}  // namespace clevis::mechanism
