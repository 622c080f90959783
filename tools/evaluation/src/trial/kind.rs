//! What can be tried.

/// What can be tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Velocities.
    Walk,
    /// Commands by chance.
    Commands,
    /// Pushes while walking.
    Pushes,
    /// Bodies and floors that differ.
    Bodies,
    /// Odometry against the truth.
    Odometry,
    /// All six kicks.
    Kicks,
    /// Falls by pushes.
    Falls,
    /// Getting up.
    GetUp,
    /// Getting up where there is little room.
    Obstacles,
    /// Games with a fall.
    Comeback,
}

impl Kind {
    /// All of them.
    pub const ALL: &[Self] = &[
        Self::Walk,
        Self::Commands,
        Self::Pushes,
        Self::Bodies,
        Self::Odometry,
        Self::Kicks,
        Self::Falls,
        Self::GetUp,
        Self::Obstacles,
        Self::Comeback,
    ];

    /// The name as it is typed.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What is tried, in a line.
    #[must_use]
    pub const fn about(self) -> &'static str {
        self.words().1
    }

    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Walk => ("walk", "Velocities, each by itself and mixed"),
            Self::Commands => ("commands", "Commands by chance for a minute"),
            Self::Pushes => ("pushes", "Pushes from all sides"),
            Self::Bodies => ("bodies", "Commands by chance with other friction, gains, torques and dead time"),
            Self::Odometry => ("odometry", "Odometry after three metres"),
            Self::Kicks => ("kicks", "All six kicks"),
            Self::Falls => ("falls", "Falls by pushes from eight sides: seen ahead, taken softly, got over"),
            Self::GetUp => ("get-up", "Getting up after being thrown over"),
            Self::Obstacles => ("obstacles", "Getting up beside a goal post, in the goal, beside the goalkeeper"),
            Self::Comeback => ("comeback", "Games in which it is knocked over, and still has to score"),
        }
    }
}
