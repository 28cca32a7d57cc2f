//! The fewest links of a polyline within a tolerance of another one.
//!
//! `js/geometry/easing-polyline.ts` performs the same operations in the same order.
//!
//! Each link is extended as far as a line stays within the tolerance. The longest line touches one boundary and ends at
//! the other one; the next link may begin anywhere between these two points.
//!
//! Source: H. Imai and M. Iri, "An optimal algorithm for approximating a piecewise linear function", Journal of
//! Information Processing 9 (1986).

use super::piecewise::Stop;

/// Halvings of the tolerance in the search for the smallest error, which is found to 2⁻¹² of the tolerance.
const ROUNDS: usize = 12;
/// The sign of each boundary: index 0 is the lower one, which sets a minimum slope; index 1 is the upper one, which sets a
/// maximum slope.
const SIGNS: [f64; 2] = [1.0, -1.0];

/// The line of a link. The next link begins on it, between the point `from` and x = `to`.
#[derive(Clone, Copy)]
struct LinkLine {
    slope: f64,
    from: Stop,
    to: f64,
}

/// The constraint that one boundary of the tolerance sets for a line.
struct Boundary {
    /// The points on the boundary.
    points: Vec<Stop>,
    /// The limit of the slopes, and the point at which it was set: the line of this slope touches it last.
    slope: f64,
    touch: usize,
    /// The convex hull, on the side of the lines, of the first `done` points.
    hull: Vec<Stop>,
    done: usize,
}

/// The polyline of the fewest stops between the ends of a run, at the smallest error that this number permits.
pub(crate) fn approximate(run: &[Stop], mut tolerance: f64) -> Vec<Stop> {
    let mut best = fewest_lines(run, tolerance);
    let mut low = 0.0;
    for _ in 0..ROUNDS {
        let middle = 0.5 * (low + tolerance);
        let lines = fewest_lines(run, middle);
        if lines.len() > best.len() {
            low = middle;
        } else {
            (tolerance, best) = (middle, lines);
        }
    }
    let inner = best
        .windows(2)
        .map(|pair| meeting_point(&pair[0], &pair[1]));
    let ends = [run[0], run[run.len() - 1]];
    std::iter::once(ends[0])
        .chain(inner)
        .chain([ends[1]])
        .collect()
}

/// The lines of the fewest links, each one as long as possible.
fn fewest_lines(run: &[Stop], tolerance: f64) -> Vec<LinkLine> {
    let end = run.len() - 1;
    let mut lines = Vec::new();
    let mut link = new_link();
    let mut k = 0;
    while k <= end {
        let [x, y] = run[k];
        // The polyline passes through both ends of the run.
        let is_pinned = k % end == 0;
        let points = SIGNS.map(|sign| [x, if is_pinned { y } else { y - sign * tolerance }]);
        // No line of the link reaches the point if the slope that it needs is beyond the limit of the other boundary.
        let out_of_reach = |&side: &usize| {
            SIGNS[side] * (slope_to(&mut link, side, points[side]) - link[1 - side].slope) > 0.0
        };
        let Some(side) = (0..2).find(out_of_reach) else {
            add_point(&mut link, 0, points[0]);
            add_point(&mut link, 1, points[1]);
            k += 1;
            continue;
        };
        let line = longest_line(&link, side, points[side], k == end);
        lines.push(line);
        // The next link begins on this line, and k stays: its point limits the next link.
        link = next_link(&link, side, line, k < end);
    }
    // Through the last point, in the middle of the possible slopes.
    let slopes = link.map(|boundary| boundary.slope);
    let slopes = match slopes.map(f64::is_finite) {
        [true, false] => [slopes[0]; 2],
        [false, true] => [slopes[1]; 2],
        _ => slopes,
    };
    lines.push(LinkLine {
        slope: 0.5 * (slopes[0] + slopes[1]),
        from: run[end],
        to: 0.0,
    });
    lines
}

/// The lower and the upper boundary, without points.
fn new_link() -> [Boundary; 2] {
    SIGNS.map(|sign| Boundary {
        points: Vec::new(),
        slope: -sign * f64::INFINITY,
        touch: 0,
        hull: Vec::new(),
        done: 0,
    })
}

/// The limit of the slope that a point of one boundary, not left of any other, sets together with the points of the other
/// boundary on its left.
fn slope_to(link: &mut [Boundary; 2], side: usize, point: Stop) -> f64 {
    let sign = SIGNS[side];
    let Boundary {
        points, hull, done, ..
    } = &mut link[1 - side];
    // With the sign, the limit is the largest slope for both sides.
    let slope = |[a, b]: Stop, [x, y]: Stop| (sign * (y - b)) / (x - a);
    while let Some(&next) = points.get(*done).filter(|p| p[0] < point[0]) {
        let turns_back = |a, b| slope(a, b) < slope(b, next);
        while let [.., a, b] = hull[..]
            && !turns_back(a, b)
        {
            hull.pop();
        }
        hull.push(next);
        *done += 1;
    }
    // Along the hull the slopes grow up to the point that the line touches, and then fall.
    let (mut low, mut high) = (0, hull.len().saturating_sub(1));
    while low < high {
        let middle = (low + high) / 2;
        if slope(hull[middle], point) < slope(hull[middle + 1], point) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    let touched = hull.get(low);
    sign * touched.map_or(f64::NEG_INFINITY, |&p| slope(p, point))
}

fn add_point(link: &mut [Boundary; 2], side: usize, point: Stop) {
    let slope = slope_to(link, side, point);
    let own = &mut link[side];
    if SIGNS[side] * (slope - own.slope) > 0.0 {
        (own.slope, own.touch) = (slope, own.points.len());
    }
    own.points.push(point);
}

/// The line that comes closest to a point that no line reaches. It ends where it leaves the boundary of this point, or at
/// the end of the run.
fn longest_line(link: &[Boundary; 2], side: usize, point: Stop, is_end: bool) -> LinkLine {
    let other = &link[1 - side];
    let (slope, from) = (other.slope, other.points[other.touch]);
    let points = &link[side].points;
    let to = if is_end {
        point[0]
    } else {
        crossing(slope, from, points[points.len() - 1], point)
    };
    LinkLine { slope, from, to }
}

/// The lines that cross a line between the point that it touches and its end.
fn next_link(link: &[Boundary; 2], side: usize, line: LinkLine, has_end: bool) -> [Boundary; 2] {
    let mut next = new_link();
    let other = &link[1 - side];
    for &point in &other.points[other.touch..] {
        add_point(&mut next, 1 - side, point);
    }
    if has_end {
        let end = [line.to, height_at(line.slope, line.from, line.to)];
        add_point(&mut next, side, end);
    }
    next
}

/// The x at which a line crosses the one between two points, which lie on different sides of it.
fn crossing(slope: f64, from: Stop, a: Stop, b: Stop) -> f64 {
    let [before, after] = [a, b].map(|[x, y]| (height_at(slope, from, x) - y).abs());
    a[0] + (before / (before + after)) * (b[0] - a[0])
}

fn height_at(slope: f64, from: Stop, x: f64) -> f64 {
    from[1] + slope * (x - from[0])
}

/// The point at which two consecutive lines meet.
fn meeting_point(line: &LinkLine, next: &LinkLine) -> Stop {
    let LinkLine { slope, from, to } = *line;
    let slope_difference = slope - next.slope;
    let away = if slope_difference == 0.0 {
        0.0
    } else {
        (height_at(next.slope, next.from, from[0]) - from[1]) / slope_difference
    };
    // The lines meet where the next link may begin; rounding may put the intersection beyond this part of the line.
    let x = (from[0] + away.max(0.0)).min(to);
    [x, height_at(slope, from, x)]
}
