//! Data of the Utah teapot by Martin Newell (1975): half-profiles and cross-sections.
//!
//! Provenance: the 1990 tea-set archive as printed in freeglut 3.4.0's `fg_teapot_data.h` (MIT-style licence), and npm
//! three 0.187.0, `examples/jsm/geometries/TeapotGeometry.js` (MIT): the coordinates of the squashed teapot, 3.15 high,
//! with the exact 2.53125 and 2.49375 that some listings round to four decimals, and the bottom. All coordinates are
//! integer multiples of 1/4000, the unit of the tables; dividing gives the published decimals bit for bit.

/// The tables are in units of 1 / `UNITS`.
pub(crate) const UNITS: f64 = 4000.0;

/// One ring of a surface of revolution: the radius, the handle length of a quarter turn (14/25 of the radius, with one
/// exception) and the height.
pub(crate) type Ring = [i16; 3];

/// The profile of rim and body, from the inner edge of the rim down: three curves.
pub(crate) const WALL: [Ring; 10] = [
    [5600, 3136, 9600],
    [5350, 2996, 10125],
    [5750, 3220, 10125],
    [6000, 3360, 9600],
    [7000, 3920, 7500],
    [8000, 4480, 5400],
    [8000, 4480, 3600],
    [8000, 4480, 1800],
    [6000, 3360, 900],
    [6000, 3360, 600],
];

/// The profile of the lid from its knob down: two curves.
pub(crate) const LID: [Ring; 7] = [
    [0, 0, 12600],
    [3200, 1800, 12600],
    [0, 0, 11400],
    [800, 448, 10800],
    [1600, 896, 10200],
    [5200, 2912, 10200],
    [5200, 2912, 9600],
];

/// The profile of the bottom from its centre outwards: one curve, rotated in the opposite sense.
pub(crate) const BOTTOM: [Ring; 4] = [
    [0, 0, 0],
    [5700, 3192, 0],
    [6000, 3360, 300],
    [6000, 3360, 600],
];

/// One cross-section of handle or spout: x and z of its two ends in the plane y = 0, and its half-width.
pub(crate) type TubeSection = [i16; 5];

/// The cross-sections of the handle from its upper end: two curves.
pub(crate) const HANDLE: [TubeSection; 7] = [
    [-6400, 8100, -6000, 9000, 1200],
    [-9200, 8100, -10000, 9000, 1200],
    [-10800, 8100, -12000, 9000, 1200],
    [-10800, 7200, -12000, 7200, 1200],
    [-10800, 6300, -12000, 5400, 1200],
    [-10000, 4500, -10600, 3750, 1200],
    [-8000, 3600, -7600, 2400, 1200],
];

/// The cross-sections of the spout from the body outwards: two curves.
pub(crate) const SPOUT: [TubeSection; 7] = [
    [6800, 5700, 6800, 2400, 2640],
    [10400, 5700, 12400, 3300, 2640],
    [9200, 8400, 9600, 8100, 1000],
    [10800, 9600, 13200, 9600, 1000],
    [11200, 9900, 14100, 9975, 1000],
    [11600, 9900, 13800, 10050, 600],
    [11200, 9600, 12800, 9600, 600],
];
