//! Lines, crossings, the circle, robots on the field, and the pose of the robot that sees them.

mod arbitrary_input;
