/** Eigenvalues and, as rows of unit length, eigenvectors of a symmetric matrix, the largest first. */
export interface Eigen {
    values: number[];
    vectors: number[][];
}

const kSweeps = 32;

/** One rotation of Jacobi's that makes entry (p, q) zero; `vectors` has eigenvectors as columns. */
function rotate(a: number[][], vectors: number[][], p: number, q: number): void {
    const at = (row: number, column: number): number => a[row]?.[column] ?? 0;
    const off = at(p, q);
    if (off === 0) {
        return;
    }
    const theta = (at(q, q) - at(p, p)) / (2 * off);
    const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.hypot(theta, 1));
    const cos = 1 / Math.hypot(t, 1);
    const sin = t * cos;
    for (const row of [...a, ...vectors]) {
        const [x = 0, y = 0] = [row[p], row[q]];
        row[p] = cos * x - sin * y;
        row[q] = sin * x + cos * y;
    }
    const [rowP = [], rowQ = []] = [a[p], a[q]];
    for (let column = 0; column < a.length; column++) {
        const [x = 0, y = 0] = [rowP[column], rowQ[column]];
        rowP[column] = cos * x - sin * y;
        rowQ[column] = sin * x + cos * y;
    }
}

/** By Jacobi's rotations (Golub and Van Loan, "Matrix Computations", sec. 8.5); `matrix` stays. */
export function symmetricEigen(matrix: readonly (readonly number[])[]): Eigen {
    const a = matrix.map((row) => [...row]);
    const vectors = a.map((row, at) => row.map((_, column) => (at === column ? 1 : 0)));
    for (let sweep = 0; sweep < kSweeps; sweep++) {
        for (let p = 0; p < a.length; p++) {
            for (let q = p + 1; q < a.length; q++) {
                rotate(a, vectors, p, q);
            }
        }
    }
    return a
        .map((row, at) => ({ value: row[at] ?? 0, vector: vectors.map((each) => each[at] ?? 0) }))
        .sort((x, y) => y.value - x.value)
        .reduce<Eigen>(
            (sorted, { value, vector }) => {
                sorted.values.push(value);
                sorted.vectors.push(vector);
                return sorted;
            },
            { values: [], vectors: [] },
        );
}
