use casteljau::models::Height;
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let pot = Surface::teapot(&TeapotOptions::default());
    let newells = Surface::teapot(&TeapotOptions::new().height(Height::Original));
    writeln!(
        out,
        "{} patches, {} points",
        pot.patch_count(),
        pot.vertices().len()
    );
    let none = (TeapotOptions::new().rim(false).body(false).handle(false))
        .spout(false)
        .lid(false)
        .bottom(false);
    for (part, options) in [
        ("rim", none.rim(true)),
        ("body", none.body(true)),
        ("handle", none.handle(true)),
        ("spout", none.spout(true)),
        ("lid", none.lid(true)),
        ("bottom", none.bottom(true)),
    ] {
        writeln!(out, "{part}: {}", Surface::teapot(&options).patch_count());
    }
    let top = |surface: &Surface| surface.bounds().unwrap().max.z;
    writeln!(out, "height {}, Newell's {}", top(&pot), top(&newells));
}
