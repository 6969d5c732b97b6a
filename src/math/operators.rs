//! Operators of number types that are an `f32` inside.

/// The operators of `f32`, and what every type around one has.
macro_rules! operators_of_f32 {
    ($type:ident: $($operator:ident $method:ident $assign:ident $assign_method:ident $symbol:tt;)*) => {
        $(
            impl core::ops::$operator for $type {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(self.0 $symbol other.0)
                }
            }

            impl core::ops::$assign for $type {
                #[inline(always)]
                fn $assign_method(&mut self, other: Self) {
                    *self = *self $symbol other;
                }
            }
        )*

        impl core::ops::Neg for $type {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl core::fmt::Display for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                self.0.fmt(f)
            }
        }

        impl From<f32> for $type {
            #[inline]
            fn from(x: f32) -> Self {
                Self(x)
            }
        }

        impl From<$type> for f32 {
            #[inline]
            fn from(x: $type) -> Self {
                x.0
            }
        }

        $crate::math::accumulate::accumulate_in_place!($type);
    };
    ($type:ident) => {
        $crate::math::operators::operators_of_f32! { $type:
            Add add AddAssign add_assign +;
            Sub sub SubAssign sub_assign -;
            Mul mul MulAssign mul_assign *;
            Div div DivAssign div_assign /;
            Rem rem RemAssign rem_assign %;
        }
    };
}
pub(super) use operators_of_f32;

/// What of [`Real`](super::Real) is as it is in `f32`.
macro_rules! as_f32 {
    () => {
        const ZERO: Self = Self(0.0);
        const HALF: Self = Self(0.5);
        const ONE: Self = Self(1.0);
        const TWO: Self = Self(2.0);
        const DISPLAY_STEP: Self = Self(1.0 / 255.0);
        const MAX: Self = Self(f32::MAX);
        const FARTHEST: Self = Self(<f32 as Real>::FARTHEST);
        const SMALLEST: Self = Self(<f32 as Real>::SMALLEST);
        const ROUNDOFF: Self = Self(<f32 as Real>::ROUNDOFF);

        #[inline(always)]
        fn from_f32(x: f32) -> Self {
            Self(x)
        }
        #[inline(always)]
        fn to_f32(self) -> f32 {
            self.0
        }
        #[inline(always)]
        fn from_u32(x: u32) -> Self {
            Self(x as f32)
        }
        #[inline(always)]
        fn abs(self) -> Self {
            Self(self.0.abs())
        }
        #[inline]
        fn sqrt(self) -> Self {
            Self(Real::sqrt(self.0))
        }
        #[inline]
        fn floor(self) -> Self {
            Self(Real::floor(self.0))
        }
        #[inline]
        fn product_error(self, other: Self, product: Self) -> Self {
            Self(self.0.product_error(other.0, product.0))
        }
    };
}
pub(super) use as_f32;
