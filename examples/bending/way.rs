//! Ways to follow paths.

use whit::scene::{Method, Steps};

/// One way to follow paths, at one length of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    pub kind: Kind,
    /// Length, tolerance or thickness.
    pub step: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Controlled,
    Fixed,
    Layers,
}

impl Kind {
    pub const ALL: [Self; 3] = [Self::Controlled, Self::Fixed, Self::Layers];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Controlled => "`Controlled`",
            Self::Fixed => "`Fixed`",
            Self::Layers => "`Layers`",
        }
    }

    /// How often a step works out n² or its gradient.
    pub const fn evaluations(self) -> u32 {
        match self {
            Self::Controlled => 3,
            Self::Fixed => 1,
            Self::Layers => 2,
        }
    }
}

impl Way {
    pub fn steps(self) -> Steps<f64> {
        match self.kind {
            Kind::Controlled => Steps::Controlled { tolerance: self.step },
            Kind::Fixed | Kind::Layers => Steps::Fixed { length: self.step },
        }
    }

    pub fn method(self) -> Method<f64> {
        match self.kind {
            Kind::Layers => Method::Layers { thickness: self.step },
            Kind::Controlled | Kind::Fixed => Method::Steps(self.steps()),
        }
    }
}
