//! Products of polynomials in Bernstein form whose coefficients are vectors, for a symmetric bilinear product of these.

/// ⟨A, A⟩ of a cubic, degree 6.
#[inline]
pub fn cubic_square<V: Copy>(a: &[V; 4], product: impl Fn(V, V) -> f64) -> [f64; 7] {
    let at = |i: usize, j: usize| product(a[i], a[j]);
    [
        at(0, 0),
        at(0, 1),
        (3.0 * at(1, 1) + 2.0 * at(0, 2)) * 0.2,
        (9.0 * at(1, 2) + at(0, 3)) * 0.1,
        (3.0 * at(2, 2) + 2.0 * at(1, 3)) * 0.2,
        at(2, 3),
        at(3, 3),
    ]
}

/// ⟨A, B⟩ of a cubic and a quadratic, degree 5.
#[inline]
pub fn cubic_by_quadratic<V: Copy>(
    a: &[V; 4],
    b: &[V; 3],
    product: impl Fn(V, V) -> f64,
) -> [f64; 6] {
    let at = |i: usize, j: usize| product(a[i], b[j]);
    [
        at(0, 0),
        (2.0 * at(0, 1) + 3.0 * at(1, 0)) * 0.2,
        (at(0, 2) + 6.0 * at(1, 1) + 3.0 * at(2, 0)) * 0.1,
        (3.0 * at(1, 2) + 6.0 * at(2, 1) + at(3, 0)) * 0.1,
        (3.0 * at(2, 2) + 2.0 * at(3, 1)) * 0.2,
        at(3, 2),
    ]
}

/// ⟨A, A⟩ of a quadratic, degree 4.
#[inline]
pub fn quadratic_square<V: Copy>(a: &[V; 3], product: impl Fn(V, V) -> f64) -> [f64; 5] {
    let at = |i: usize, j: usize| product(a[i], a[j]);
    [
        at(0, 0),
        at(0, 1),
        (at(0, 2) + 2.0 * at(1, 1)) * (1.0 / 3.0),
        at(1, 2),
        at(2, 2),
    ]
}

/// ⟨A, B⟩ of two quadratics, degree 4.
#[inline]
pub fn quadratic_by_quadratic<V: Copy>(
    a: &[V; 3],
    b: &[V; 3],
    product: impl Fn(V, V) -> f64,
) -> [f64; 5] {
    let at = |i: usize, j: usize| product(a[i], b[j]);
    [
        at(0, 0),
        (at(0, 1) + at(1, 0)) * 0.5,
        (at(0, 2) + 4.0 * at(1, 1) + at(2, 0)) * (1.0 / 6.0),
        (at(1, 2) + at(2, 1)) * 0.5,
        at(2, 2),
    ]
}

/// ⟨A, B⟩ of a cubic and a polynomial of degree 1, degree 4.
#[inline]
pub fn cubic_by_linear<V: Copy>(a: &[V; 4], b: &[V; 2], product: impl Fn(V, V) -> f64) -> [f64; 5] {
    let at = |i: usize, j: usize| product(a[i], b[j]);
    [
        at(0, 0),
        (at(0, 1) + 3.0 * at(1, 0)) * 0.25,
        (at(1, 1) + at(2, 0)) * 0.5,
        (3.0 * at(2, 1) + at(3, 0)) * 0.25,
        at(3, 1),
    ]
}
