//! Benchmark inputs: the same seeded cubics in the types of all three libraries.

use casteljau::Curve;
use casteljau::glam::DVec2;
use kurbo::CubicBez;
use lyon_geom::CubicBezierSegment;

/// The number of cubics and of parameters.
pub(crate) const COUNT: usize = 1000;

/// Control points are random in a square of this size.
const SIZE: f64 = 200.0;

/// The same curves in the same order.
pub(crate) struct Cubics {
    pub(crate) kurbo: Vec<CubicBez>,
    pub(crate) lyon: Vec<CubicBezierSegment<f64>>,
    pub(crate) ours: Vec<Curve<DVec2>>,
}

impl Cubics {
    pub(crate) fn new() -> Self {
        let mut random = Random(1);
        let mut cubics = Self {
            kurbo: Vec::new(),
            lyon: Vec::new(),
            ours: Vec::new(),
        };
        for _ in 0..COUNT {
            cubics.push([(); 4].map(|()| [(); 2].map(|()| SIZE * random.next())));
        }
        cubics
    }

    fn push(&mut self, points: [[f64; 2]; 4]) {
        let [p0, p1, p2, p3] = points;
        self.kurbo
            .push(CubicBez::new(xy(p0), xy(p1), xy(p2), xy(p3)));
        self.lyon.push(CubicBezierSegment {
            from: p0.into(),
            ctrl1: p1.into(),
            ctrl2: p2.into(),
            to: p3.into(),
        });
        self.ours
            .push(Curve::new(&points.map(DVec2::from)).expect("finite points"));
    }
}

fn xy([x, y]: [f64; 2]) -> (f64, f64) {
    (x, y)
}

/// Parameters in [0, 1), one for each cubic.
pub(crate) fn parameters() -> Vec<f64> {
    let mut random = Random(2);
    (0..COUNT).map(|_| random.next()).collect()
}

/// Random numbers in [0, 1) from a seed: SplitMix64 (Steele, Lea and Flood, 2014).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
