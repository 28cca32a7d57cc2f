//! Easings.

use crate::easing::{Easing, Kind};
use serde::de::{Deserialize, Deserializer, Error};
use serde::{Deserialize as Read, Serialize as Write, Serializer};

/// `[x1, y1, x2, y2]`, or CSS text for `steps()` and `linear()`.
#[derive(Read)]
#[serde(untagged)]
enum EasingForm {
    Handles([f64; 4]),
    Css(String),
}

impl Write for Easing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.kind {
            Kind::Cubic(cubic) => cubic.handles.serialize(serializer),
            _ => serializer.collect_str(self),
        }
    }
}

impl<'de> Deserialize<'de> for Easing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match EasingForm::deserialize(deserializer)? {
            EasingForm::Handles([x1, y1, x2, y2]) => {
                Self::new(x1, y1, x2, y2).map_err(D::Error::custom)
            }
            EasingForm::Css(text) => text.parse().map_err(D::Error::custom),
        }
    }
}
