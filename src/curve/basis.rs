//! Cubic curves in other bases: Hermite, B-spline, Catmull-Rom, or any 4×4 basis matrix.
//!
//! Every cubic is [t³ t² t 1]·M·G with a basis matrix M and four geometry points G. A change of basis keeps the curve
//! and changes the points: M₁·G₁ = M₂·G₂.

use super::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

/// A 4×4 matrix, row-major.
pub(crate) type Matrix = [f64; 16];

/// A cubic basis. Source of the matrices: Foley et al., *Computer Graphics: Principles and Practice*, 2nd ed., §11.2.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Basis {
    /// Geometry P₀, P₁, P₂, P₃.
    Bezier,
    /// Geometry P₀, P₁, M₀, M₁: the end points and the derivatives at them.
    Hermite,
    /// Geometry P₀ … P₃: one segment of the uniform cubic B-spline.
    BSpline,
    /// Geometry P₀ … P₃: from P₁ to P₂, with the derivatives (P₂ − P₀)/2 and (P₃ − P₁)/2 (uniform, tension ½).
    CatmullRom,
    /// A custom matrix, row-major, used as [t³ t² t 1]·M·G.
    Matrix([f64; 16]),
}

impl Basis {
    /// The basis matrix, row-major: the rows belong to t³, t², t and 1, the columns to the four geometry points.
    pub fn matrix(&self) -> [f64; 16] {
        // The common factor of the matrix of the uniform cubic B-spline.
        const S: f64 = 1.0 / 6.0;
        match *self {
            Self::Bezier => [
                -1., 3., -3., 1., 3., -6., 3., 0., -3., 3., 0., 0., 1., 0., 0., 0.,
            ],
            Self::Hermite => [
                2., -2., 1., 1., -3., 3., -2., -1., 0., 0., 1., 0., 1., 0., 0., 0.,
            ],
            Self::BSpline => [
                -S,
                0.5,
                -0.5,
                S,
                0.5,
                -1.,
                0.5,
                0.,
                -0.5,
                0.,
                0.5,
                0.,
                S,
                4. * S,
                S,
                0.,
            ],
            Self::CatmullRom => [
                -0.5, 1.5, -1.5, 0.5, 1., -2.5, 2., -0.5, -0.5, 0., 0.5, 0., 0., 1., 0., 0.,
            ],
            Self::Matrix(matrix) => matrix,
        }
    }

    /// The matrix that converts geometry points to Bézier points; returns an error for a NaN or an infinity.
    pub(crate) fn to_bezier(self) -> Result<Matrix, Error> {
        finite(self.matrix()).map(|matrix| to_bezier(&matrix))
    }
}

/// The matrix that converts geometry points of a basis to Bézier points: the rows belong to P₀ … P₃.
fn to_bezier(matrix: &Matrix) -> Matrix {
    let [a, b, c, d] = rows(matrix);
    // The inverse of the Bézier matrix: P₀ = d, P₁ = d + c/3, P₂ = d + 2c/3 + b/3, P₃ = d + c + b + a.
    let mut out = [0.0; 16];
    for k in 0..4 {
        out[k] = d[k];
        out[4 + k] = (3.0 * d[k] + c[k]) / 3.0;
        out[8 + k] = (3.0 * d[k] + 2.0 * c[k] + b[k]) / 3.0;
        out[12 + k] = a[k] + b[k] + c[k] + d[k];
    }
    out
}

/// M·G, four points.
pub(crate) fn apply<P: Point>(matrix: &Matrix, points: [P; 4]) -> [P; 4] {
    let [p0, p1, p2, p3] = points;
    rows(matrix).map(|[a, b, c, d]| p0 * a + p1 * b + p2 * c + p3 * d)
}

fn rows(m: &Matrix) -> [[f64; 4]; 4] {
    [
        [m[0], m[1], m[2], m[3]],
        [m[4], m[5], m[6], m[7]],
        [m[8], m[9], m[10], m[11]],
        [m[12], m[13], m[14], m[15]],
    ]
}

/// The inverse by Gauss–Jordan elimination with partial pivoting; `None` if a pivot is negligible relative to the
/// largest entry.
fn invert(matrix: &Matrix) -> Option<Matrix> {
    let size = matrix.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let mut left = rows(matrix);
    let mut right = rows(&[
        1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.,
    ]);
    for k in 0..4 {
        let pivot = (k..4).max_by(|&a, &b| left[a][k].abs().total_cmp(&left[b][k].abs()))?;
        // The entries are finite; a zero matrix also fails this test.
        if left[pivot][k].abs() <= size * f64::EPSILON {
            return None;
        }
        left.swap(k, pivot);
        right.swap(k, pivot);
        let inverse = 1.0 / left[k][k];
        for column in 0..4 {
            left[k][column] *= inverse;
            right[k][column] *= inverse;
        }
        for row in (0..4).filter(|&row| row != k) {
            let factor = left[row][k];
            for column in 0..4 {
                left[row][column] -= factor * left[k][column];
                right[row][column] -= factor * right[k][column];
            }
        }
    }
    let mut out = [0.0; 16];
    for (i, row) in right.iter().enumerate() {
        out[4 * i..4 * i + 4].copy_from_slice(row);
    }
    Some(out)
}

impl<P: Point> Curve<P> {
    /// The cubic Bézier curve of four geometry points in another basis.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity in the points or the matrix.
    pub fn from_basis(basis: Basis, points: [P; 4]) -> Result<Self, Error> {
        crate::geometry::check::check_points("points", &points)?;
        Self::new(&apply(&basis.to_bezier()?, points))
    }

    /// The four geometry points of this cubic in another basis; the inverse of [`from_basis`](Self::from_basis).
    ///
    /// A curve of a lower degree is elevated first.
    ///
    /// # Errors
    /// [`Error::Count`] for a degree above 3, [`Error::Singular`] for a matrix without an inverse (its four points do
    /// not determine a cubic), [`Error::NotFinite`] for a NaN or an infinity in it.
    pub fn to_basis(&self, basis: Basis) -> Result<[P; 4], Error> {
        let inverse = invert(&basis.to_bezier()?).ok_or(Error::Singular { what: "basis" })?;
        Ok(apply(&inverse, self.as_cubic()?))
    }

    /// The four control points of a curve of degree 1 to 3, elevated if necessary.
    fn as_cubic(&self) -> Result<[P; 4], Error> {
        match *self.points {
            [p0, p1, p2, p3] => Ok([p0, p1, p2, p3]),
            [_, _] | [_, _, _] => self.elevated().as_cubic(),
            _ => Err(Error::Count {
                what: "points",
                expected: "at most 4 (degree 3)",
                got: self.points.len(),
            }),
        }
    }
}

fn finite(matrix: Matrix) -> Result<Matrix, Error> {
    Error::unless_finite("basis", &matrix).map(|()| matrix)
}
