use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for (upper, lower) in [(0, 4), (4, 8)] {
        // They share v = 1 and v = 0.
        let (above, below) = (teapot.patch(upper).unwrap(), teapot.patch(lower).unwrap());
        let ratio = below.partials(0.3, 0.0).v.length() / above.partials(0.3, 1.0).v.length();
        let cosine = above.normal(0.3, 1.0).dot(below.normal(0.3, 0.0));
        writeln!(
            out,
            "patches {upper} and {lower}: ratio {ratio:.3}, cosine of the angle {cosine:.6}"
        );
    }
}
