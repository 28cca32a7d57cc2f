//! Cosine and sine of the core, compared with the standard library.

use casteljau_kernels::cos_sin;

#[test]
fn as_the_standard_library() {
    for k in -4000..=4000 {
        let angle = f64::from(k) * 0.002_345;
        let (cos, sin) = cos_sin(angle);
        assert!((cos - angle.cos()).abs() <= 4.5e-16, "cos {angle}: {cos}");
        assert!((sin - angle.sin()).abs() <= 4.5e-16, "sin {angle}: {sin}");
    }
    assert_eq!(cos_sin(0.0), (1.0, 0.0));
}
