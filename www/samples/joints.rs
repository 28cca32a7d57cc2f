use casteljau::spline::{Continuity, JointMode};
use casteljau::{Spline, glam::DVec2};

fn names(of: Continuity) -> String {
    let all = [
        ("C0", of.c0),
        ("G1", of.g1),
        ("C1", of.c1),
        ("G2", of.g2),
        ("C2", of.c2),
    ];
    let held: Vec<&str> = all
        .iter()
        .filter(|(_, holds)| *holds)
        .map(|(name, _)| *name)
        .collect();
    held.join(" ")
}

pub(crate) fn sample(out: &mut String) {
    // P2, P3, P4 lie on one line, but P3 is not the midpoint: G1, not C1.
    let points = [
        (70.0, 330.0),
        (90.0, 120.0),
        (210.0, 100.0),
        (330.0, 200.0),
        (390.0, 250.0),
        (520.0, 400.0),
        (600.0, 160.0),
    ];
    let spline = Spline::new(&points.map(DVec2::from), 3, false).unwrap();
    let aligned = names(spline.continuity(1).unwrap());
    writeln!(out, "aligned: {aligned}");

    let (before, after) = (spline.segment(0).unwrap(), spline.segment(1).unwrap());
    let (a, b) = (
        before.derivative_at(1.0, 1).length(),
        after.derivative_at(0.0, 1).length(),
    );
    writeln!(out, "speed at P3: {a:.1} before, {b:.1} after");

    for (name, mode) in [
        ("C1", JointMode::C1),
        ("G2", JointMode::G2),
        ("C2", JointMode::C2),
    ] {
        let set = spline.set_joint(1, mode).unwrap();
        let text = names(set.continuity(1).unwrap());
        writeln!(out, "set to {name}: {text}");
    }

    // Move P2 and keep the joint C1: P4 moves as well.
    let mut held = spline.set_joint(1, JointMode::C1).unwrap();
    held.move_point(2, DVec2::new(230.0, 60.0), |_| JointMode::C1)
        .unwrap();
    let p4 = held.control_points()[4];
    writeln!(out, "P4 is now ({}, {})", p4.x, p4.y);
}
