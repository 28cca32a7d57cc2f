//! Vectors of two f64 or four f32.
//!
//! Every operation is that of the single numbers, so the results are those of the scalar formula, bit for bit. With the
//! feature `surfaces` the types are those of the crate `wide`. Without it they are arrays, of which LLVM makes the same
//! SIMD instructions for curves, but not for meshes, nor in the build for wasm, which is optimized for size.

#[cfg(feature = "surfaces")]
pub use wide::{f32x4, f64x2};

#[cfg(not(feature = "surfaces"))]
pub use array::{f32x4, f64x2};

/// `yes` where `a` is greater than `b`, and `no` elsewhere.
#[cfg(feature = "surfaces")]
#[inline(always)]
pub fn if_greater(a: f32x4, b: f32x4, yes: f32x4, no: f32x4) -> f32x4 {
    a.simd_gt(b).bitselect(yes, no)
}

/// `yes` where `a` is greater than `b`, and `no` elsewhere.
#[cfg(not(feature = "surfaces"))]
#[inline(always)]
pub fn if_greater(a: f32x4, b: f32x4, yes: f32x4, no: f32x4) -> f32x4 {
    let [a, b, yes, no] = [a, b, yes, no].map(f32x4::to_array);
    f32x4::new(std::array::from_fn(|i| {
        if a[i] > b[i] { yes[i] } else { no[i] }
    }))
}

/// What is used of `wide`, for arrays.
#[cfg(any(test, not(feature = "surfaces")))]
pub mod array {
    use crate::numeric::order::{larger, smaller};
    use std::array::from_fn;
    use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Sub};

    macro_rules! operator {
        ($Lanes:ident, $Operator:ident, $operator:ident) => {
            impl $Operator for $Lanes {
                type Output = Self;

                #[inline(always)]
                fn $operator(self, other: Self) -> Self {
                    Self(from_fn(|i| self.0[i].$operator(other.0[i])))
                }
            }
        };
    }

    macro_rules! lanes {
        ($Lanes:ident, $T:ty, $N:literal) => {
            /// A vector of numbers.
            #[allow(non_camel_case_types, reason = "the name in `wide`")]
            #[derive(Clone, Copy, Debug)]
            pub struct $Lanes([$T; $N]);

            impl $Lanes {
                /// Zeros.
                pub const ZERO: Self = Self([0.0; $N]);

                /// The vector of these numbers.
                #[inline(always)]
                pub const fn new(numbers: [$T; $N]) -> Self {
                    Self(numbers)
                }

                /// The vector of equal numbers.
                #[inline(always)]
                pub const fn splat(number: $T) -> Self {
                    Self([number; $N])
                }

                /// The numbers.
                #[inline(always)]
                pub const fn to_array(self) -> [$T; $N] {
                    self.0
                }

                /// The larger numbers, if none is NaN.
                #[inline(always)]
                pub fn fast_max(self, other: Self) -> Self {
                    Self(from_fn(|i| larger(self.0[i], other.0[i])))
                }

                /// The smaller numbers, if none is NaN.
                #[inline(always)]
                pub fn fast_min(self, other: Self) -> Self {
                    Self(from_fn(|i| smaller(self.0[i], other.0[i])))
                }

                /// The square roots.
                #[inline(always)]
                pub fn sqrt(self) -> Self {
                    Self(self.0.map(<$T>::sqrt))
                }

                /// The absolute values.
                #[inline(always)]
                pub fn abs(self) -> Self {
                    Self(self.0.map(<$T>::abs))
                }
            }

            operator!($Lanes, Add, add);
            operator!($Lanes, Sub, sub);
            operator!($Lanes, Mul, mul);
            operator!($Lanes, Div, div);

            impl AddAssign for $Lanes {
                #[inline(always)]
                fn add_assign(&mut self, other: Self) {
                    *self = *self + other;
                }
            }

            impl MulAssign for $Lanes {
                #[inline(always)]
                fn mul_assign(&mut self, other: Self) {
                    *self = *self * other;
                }
            }
        };
    }

    lanes!(f64x2, f64, 2);
    lanes!(f32x4, f32, 4);

    impl f32x4 {
        /// The columns of four rows.
        #[inline(always)]
        pub fn transpose(rows: [Self; 4]) -> [Self; 4] {
            from_fn(|i| Self(rows.map(|row| row.0[i])))
        }
    }
}

#[cfg(all(test, feature = "surfaces"))]
mod tests {
    use super::array;

    /// Every operation on these numbers, by both implementations, bit for bit.
    macro_rules! compare {
        ($Lanes:ident, $T:ty, $numbers:expr) => {
            let (a, b): ([$T; _], [$T; _]) = $numbers;
            let (x, y) = (wide::$Lanes::new(a), wide::$Lanes::new(b));
            let (u, v) = (array::$Lanes::new(a), array::$Lanes::new(b));
            let bits = |numbers: [$T; _]| numbers.map(<$T>::to_bits);
            let same = |wide: wide::$Lanes, array: array::$Lanes| {
                assert_eq!(bits(wide.to_array()), bits(array.to_array()), "{a:?} {b:?}");
            };
            same(x + y, u + v);
            same(x - y, u - v);
            same(x * y, u * v);
            same(x / y, u / v);
            same(x.fast_max(y), u.fast_max(v));
            same(x.fast_min(y), u.fast_min(v));
            same(x.abs(), u.abs());
            same(x.abs().sqrt(), u.abs().sqrt());
            same(wide::$Lanes::splat(a[0]), array::$Lanes::splat(a[0]));
            same(wide::$Lanes::ZERO, array::$Lanes::ZERO);
        };
    }

    #[test]
    fn arrays_give_the_numbers_of_wide() {
        compare!(f64x2, f64, ([1.0 / 3.0, -7e200], [-0.3, 1e-150]));
        compare!(f64x2, f64, ([5e-324, 0.1], [3.0, 0.7]));
        compare!(
            f32x4,
            f32,
            ([0.1, -2.5, 1e-40, 7e30], [0.3, 1e-3, -4.0, 1e20])
        );
        let rows = [
            [1.0, 2.0, 3.0, 4.0],
            [5.0, 6.0, 7.0, 8.0],
            [0.1; 4],
            [-1.0; 4],
        ];
        let columns = wide::f32x4::transpose(rows.map(wide::f32x4::new));
        let same = array::f32x4::transpose(rows.map(array::f32x4::new));
        assert_eq!(
            columns.map(wide::f32x4::to_array),
            same.map(array::f32x4::to_array)
        );
    }
}
