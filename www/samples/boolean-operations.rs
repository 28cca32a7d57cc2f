use casteljau::Path;
use casteljau::path::FillRule::NonZero;

pub(crate) fn sample(out: &mut String) {
    let a = Path::from_svg("M0 0H4V4H0Z").unwrap();
    let b = Path::from_svg("M2 2H6V6H2Z").unwrap();
    writeln!(out, "union {:.1}", a.union(&b, NonZero).unwrap().area());
    let both = a.intersect(&b, NonZero).unwrap();
    writeln!(out, "intersection {:.1}", both.area());
    let difference = a.subtract(&b, NonZero).unwrap();
    writeln!(out, "difference {:.1}", difference.area());
    let exclusive = a.exclude(&b, NonZero).unwrap();
    writeln!(out, "exclusive or {:.1}", exclusive.area());

    // The faces into which both outlines divide the plane.
    let faces = Path::faces([&a, &b], NonZero).unwrap();
    let mut texts: Vec<String> = faces
        .iter()
        .map(|face| {
            let place = match (face.inside[0], face.inside[1]) {
                (true, true) => "both",
                (true, false) => "A",
                _ => "B",
            };
            format!("{place} {:.1}", face.path.area())
        })
        .collect();
    texts.sort();
    writeln!(out, "faces: {}", texts.join(", "));
}
