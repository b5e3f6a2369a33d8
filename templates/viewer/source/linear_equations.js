// Square linear equations, row by row in a Float64Array: elimination with the largest pivot of a column.

export class Factor {
  constructor(size) {
    this.size = size;
    this.entries = new Float64Array(size * size);
    this.order = new Int32Array(size);
  }

  /// Of the matrix, which stays as it is. Returns whether it is regular and finite.
  of(matrix) {
    const { size: n, entries: a, order } = this;
    a.set(matrix);
    for (let k = 0; k < n; ++k) {
      let row = k;
      for (let i = k + 1; i < n; ++i) if (Math.abs(a[i * n + k]) > Math.abs(a[row * n + k])) row = i;
      order[k] = row;
      const pivot = a[row * n + k];
      if (!(Math.abs(pivot) > 0) || !Number.isFinite(pivot)) return false;
      if (row !== k)
        for (let j = 0; j < n; ++j) [a[k * n + j], a[row * n + j]] = [a[row * n + j], a[k * n + j]];
      for (let i = k + 1; i < n; ++i) {
        const share = a[i * n + k] / pivot;
        if (share === 0) continue;  // trees have many
        a[i * n + k] = share;
        for (let j = k + 1; j < n; ++j) a[i * n + j] -= share * a[k * n + j];
      }
    }
    return true;
  }

  /// The solution, in place.
  solve(x) {
    const { size: n, entries: a, order } = this;
    for (let k = 0; k < n; ++k) [x[k], x[order[k]]] = [x[order[k]], x[k]];
    for (let i = 1; i < n; ++i) {
      let sum = x[i];
      for (let j = 0; j < i; ++j) sum -= a[i * n + j] * x[j];
      x[i] = sum;
    }
    for (let i = n - 1; i >= 0; --i) {
      let sum = x[i];
      for (let j = i + 1; j < n; ++j) sum -= a[i * n + j] * x[j];
      x[i] = sum / a[i * n + i];
    }
    return x;
  }
}

const kRedundant = 1e-10;  // of a row's own entry, added to it: rows that follow from others share what they bear

/// [A -P^T; P 0] [x; lambda] = [b; c]: x takes the place of b.
export class ConstrainedEquations {
  constructor(size, rows) {
    this.size = size;
    this.rows = rows;
    this.factor = new Factor(size);
    this.inner = new Factor(rows);
    this.S = new Float64Array(rows * rows);
    this.columns = Array.from({ length: rows }, () => new Float64Array(size));
    this.lambda = new Float64Array(rows);
  }

  solve(A, b, P, c) {
    if (!this.factor.of(A)) return false;
    this.factor.solve(b);
    if (this.rows === 0) return true;
    const { size: n, rows: m, S, columns, lambda } = this;
    for (let r = 0; r < m; ++r) {
      for (let i = 0; i < n; ++i) columns[r][i] = P[r * n + i];
      this.factor.solve(columns[r]);
    }
    for (let r = 0; r < m; ++r) {
      let rest = c[r];
      for (let i = 0; i < n; ++i) rest -= P[r * n + i] * b[i];
      lambda[r] = rest;
      for (let s = 0; s < m; ++s) {
        let sum = 0;
        for (let i = 0; i < n; ++i) sum += P[r * n + i] * columns[s][i];
        S[r * m + s] = sum;
      }
    }
    for (let r = 0; r < m; ++r) {
      if (S[r * m + r] !== 0) S[r * m + r] *= 1 + kRedundant;
      else [S[r * m + r], lambda[r]] = [1, 0];  // a row of zeros
    }
    if (!this.inner.of(S)) return false;
    this.inner.solve(lambda);
    for (let r = 0; r < m; ++r) for (let i = 0; i < n; ++i) b[i] += columns[r][i] * lambda[r];
    return true;
  }
}
