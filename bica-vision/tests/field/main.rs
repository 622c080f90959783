//! What stands and lies on the field: lines, crossings, the circle, robots, and the place of the robot that sees them.

mod nonsense;
