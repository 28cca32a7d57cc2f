use casteljau::models::{Height, Up};
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let pot = Surface::teapot(TeapotOptions::default());
    let newells = Surface::teapot(TeapotOptions {
        height: Height::Original,
        ..TeapotOptions::default()
    });
    writeln!(
        out,
        "{} patches, {} points",
        pot.patch_count(),
        pot.vertices().len()
    );
    let none = TeapotOptions {
        rim: false,
        body: false,
        handle: false,
        spout: false,
        lid: false,
        bottom: false,
        height: Height::Squashed,
        up: Up::Z,
    };
    for (part, options) in [
        ("rim", TeapotOptions { rim: true, ..none }),
        ("body", TeapotOptions { body: true, ..none }),
        (
            "handle",
            TeapotOptions {
                handle: true,
                ..none
            },
        ),
        (
            "spout",
            TeapotOptions {
                spout: true,
                ..none
            },
        ),
        ("lid", TeapotOptions { lid: true, ..none }),
        (
            "bottom",
            TeapotOptions {
                bottom: true,
                ..none
            },
        ),
    ] {
        writeln!(out, "{part}: {}", Surface::teapot(options).patch_count());
    }
    let top = |surface: &Surface| surface.bounds().unwrap().max.z;
    writeln!(out, "height {}, Newell's {}", top(&pot), top(&newells));
}
