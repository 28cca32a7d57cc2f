//! Contacts that belong together.

use super::pair::Pair;
use casteljau_kernels::Contact;

/// Gaps between contacts that are looked into; what is farther apart in either parameter is another place.
const LARGEST_GAP: f64 = 0.05;

/// Parameters so close are one for sure: some roundings.
const SAME: f64 = 1e-13;

/// A stretch on which two curves cannot be told apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Zone {
    pub(super) t: [f64; 2],
    /// The least and the greatest parameter on the second curve.
    pub(super) u: [f64; 2],
    /// 1 where u grows with t, −1 where it falls, 0 where it is not known.
    pub(super) direction: f64,
    /// It is nothing but one crossing.
    pub(super) crossing: bool,
    /// The last contact that was joined to it.
    last: Contact,
}

impl Zone {
    fn new(contact: Contact) -> Self {
        let [u0, u1] = contact.u;
        // A box of a few roundings says nothing of a direction.
        let wide = contact.t[1] - contact.t[0] > 1e-6;
        Self {
            t: contact.t,
            u: [u0.min(u1), u0.max(u1)],
            direction: if wide { (u1 - u0).signum() } else { 0.0 },
            crossing: contact.crossing,
            last: contact,
        }
    }

    /// Both ends, u in the order of t.
    pub(super) fn ends(&self) -> [(f64, f64); 2] {
        let [u0, u1] = self.u;
        if self.direction < 0.0 {
            [(self.t[0], u1), (self.t[1], u0)]
        } else {
            [(self.t[0], u0), (self.t[1], u1)]
        }
    }

    /// Whether a place is in it, give or take its width.
    pub(super) fn holds(&self, (t, u): (f64, f64)) -> bool {
        let within = |[from, to]: [f64; 2], x: f64| {
            let margin = (to - from) + 1e-7;
            x >= from - margin && x <= to + margin
        };
        within(self.t, t) && within(self.u, u)
    }

    /// Whether a contact that starts later is a part or the continuation of this one.
    fn takes(&self, pair: &Pair, next: &Zone) -> bool {
        if self.direction * next.direction < 0.0 {
            return false;
        }
        let (t, u) = (next.t[0], 0.5 * (next.u[0] + next.u[1]));
        let Contact {
            t: last_t,
            u: last_u,
            ..
        } = self.last;
        let [width_t, width_u] = [last_t[1] - last_t[0], last_u[1] - last_u[0]];
        if t < last_t[1] - SAME {
            // Within it: at the place that corresponds?
            let place = last_u[0] + width_u * (t - last_t[0]) / width_t;
            let start = if self.direction < 0.0 {
                next.u[1]
            } else {
                next.u[0]
            };
            return (start - place).abs() <= 0.01 * width_u * width_u + 1e-7;
        }
        let gap_t = t - self.t[1].max(last_t[1]);
        let gap_u = (next.u[0] - self.u[1]).max(self.u[0] - next.u[1]).max(0.0);
        if gap_t <= SAME && gap_u <= SAME {
            return true;
        }
        let from = if u > self.u[1] { self.u[1] } else { self.u[0] };
        let to = if u > self.u[1] { next.u[0] } else { next.u[1] };
        gap_t < LARGEST_GAP
            && gap_u < LARGEST_GAP
            && [0.25, 0.5, 0.75].iter().all(|&part| {
                let (t, u) = (
                    self.t[1] + part * (t - self.t[1]),
                    from + part * (to - from),
                );
                pair.height(t, u).abs() <= 4.0 * pair.slack
            })
    }

    fn join(&mut self, next: &Zone) {
        self.t[1] = self.t[1].max(next.t[1]);
        self.u = [self.u[0].min(next.u[0]), self.u[1].max(next.u[1])];
        if self.direction == 0.0 {
            self.direction = next.direction;
        }
        self.crossing &= next.crossing;
        if next.t[1] > self.last.t[1] {
            self.last = next.last;
        }
    }
}

/// The contacts in order, joined where they belong together.
pub(super) fn joined(pair: &Pair, mut contacts: Vec<Contact>) -> Vec<Zone> {
    contacts.sort_by(|p, q| p.t[0].total_cmp(&q.t[0]).then(p.u[0].total_cmp(&q.u[0])));
    let mut zones: Vec<Zone> = Vec::with_capacity(contacts.len());
    for contact in contacts {
        let next = Zone::new(contact);
        let near = zones
            .iter()
            .rposition(|zone| next.t[0] - zone.t[1] < LARGEST_GAP && zone.takes(pair, &next));
        match near {
            Some(k) => zones[k].join(&next),
            None => zones.push(next),
        }
    }
    zones
}
