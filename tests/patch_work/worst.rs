//! Questions that took the longest before the searches ended where rounding decides, found among generated ones.

use casteljau::Patch;
use casteljau::glam::DVec3;

/// A patch and a point.
pub(crate) struct Asked {
    pub(crate) name: &'static str,
    pub(crate) patch: Patch,
    pub(crate) point: DVec3,
}

fn asked(name: &'static str, degrees: [usize; 2], net: &[[f64; 3]], point: [f64; 3]) -> Asked {
    let net: Vec<DVec3> = net.iter().map(|&p| DVec3::from(p)).collect();
    let patch = Patch::new(&net, degrees[0], degrees[1]).expect("finite points");
    Asked {
        name,
        patch,
        point: DVec3::from(point),
    }
}

/// Nets on which not one point but whole curves are nearest, or whole areas to rounding.
pub(crate) fn nearest_along_curves() -> Vec<Asked> {
    vec![
        asked(
            "control points on a line, beside it",
            [1, 1],
            &[
                [
                    -0.11568053186879618,
                    -0.7730405609404261,
                    1.1939980407378215,
                ],
                [0.14832834464294908, -0.7078240882686364, 1.4310550620364346],
                [-0.4734248072961791, -0.8614119068972776, 0.8727747794598122],
                [-1.0748601513012193, -1.009980743651553, 0.3327381222181053],
            ],
            [0.27095403133100143, -0.20358725142090534, 0.0],
        ),
        asked(
            "three corners at one place, far from the origin",
            [1, 1],
            &[
                [1000001.0, 0.5239885534305784, -1.0],
                [999999.0, -0.997186598776814, 0.7828868386482486],
                [1000001.0, 0.5239885534305784, -1.0],
                [1000001.0, 0.5239885534305784, -1.0],
            ],
            [1000000.5277578433, 0.1648070360840199, -0.57902283702595],
        ),
        asked(
            "sizes from 1e-9 to 1e10, nearly a line, on it",
            [1, 1],
            &[
                [-1.8526017657834424e-6, 100.17211922832803, 0.0],
                [34.34380701470175, 76656394.76150051, 0.0],
                [3.803745328134583e-9, 4.4585738127227887e-7, 0.0],
                [-0.017894947970105064, -17027891944.868147, 0.0],
            ],
            [8.581477554483408, -4237808862.4836316, 0.0],
        ),
        asked(
            "sizes from 1e-12 to 1e10 in a plane",
            [2, 1],
            &[
                [3.46981747726065e-7, 0.0, -1.4253820178793841e-6],
                [0.0, -1.5013438707844392e-12, -1.4253820178793841e-6],
                [
                    1.129484731420158e-10,
                    -21660126730.302094,
                    -1.4253820178793841e-6,
                ],
                [
                    -5.648382397347605e-5,
                    -0.015362841689624313,
                    -1.4253820178793841e-6,
                ],
                [0.0, 38143.38273943783, -1.4253820178793841e-6],
                [0.0, -9.47841339549294e-12, -1.4253820178793841e-6],
            ],
            [
                -9.356121546212809e-6,
                -3610014764.48912,
                -1.4253820178793841e-6,
            ],
        ),
    ]
}
