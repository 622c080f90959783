//! Kinds of trials.

/// Kind of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Velocities.
    Walk,
    /// Random commands.
    Commands,
    /// Pushes while walking.
    Pushes,
    /// Other bodies and floors.
    Bodies,
    /// Error of odometry.
    Odometry,
    /// All six kicks.
    Kicks,
    /// Falls after pushes.
    Falls,
    /// Getting up from all sides.
    GetUp,
    /// Getting up beside obstacles.
    Obstacles,
    /// Games with a fall.
    Comeback,
}

impl Kind {
    /// All kinds.
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

    /// Returns the name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.texts().0
    }

    /// Returns a description in one line.
    #[must_use]
    pub const fn about(self) -> &'static str {
        self.texts().1
    }

    const fn texts(self) -> (&'static str, &'static str) {
        match self {
            Self::Walk => ("walk", "Single and combined velocities: mean velocity and falls"),
            Self::Commands => ("commands", "Random velocity commands for one minute: falls"),
            Self::Pushes => ("pushes", "Pushes from random directions while walking: falls"),
            Self::Bodies => ("bodies", "Random commands with other friction, gains, torques and dead time: falls"),
            Self::Odometry => ("odometry", "Error of odometry after three metres"),
            Self::Kicks => ("kicks", "All six kicks and the in-walk kicks: distance and direction of the ball"),
            Self::Falls => ("falls", "Falls to eight sides: detected before the impact, joints relaxed, recovered"),
            Self::GetUp => ("get-up", "Getting up after a fall to each side"),
            Self::Obstacles => ("obstacles", "Getting up beside a goal post, in the goal, beside the goalkeeper"),
            Self::Comeback => ("comeback", "Games in which the robot is pushed over and still has to score"),
        }
    }
}
