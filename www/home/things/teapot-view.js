// How the teapot is shown. The build draws its first picture with it.

/** Attributes of `<bezier-surface>`. */
export const TEAPOT = { model: "teapot", show: "surface net isocurves", lines: "1", patch: "10" };
export const TEAPOT_VIEW = { turn: -38, tilt: 22, zoom: 1.28, panX: 0, panY: 0 };
