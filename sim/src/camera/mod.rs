//! The robot's camera as both simulators model it: pinhole projection, colours, and the image sensor.
//!
//! A simulator draws an ideal picture on a [`canvas`]; the [`image_sensor`] adds motion blur, vignetting and noise and
//! packs it as YUYV.

pub(crate) mod canvas;
pub(crate) mod image_sensor;
pub(crate) mod light;
pub(crate) mod palette;
pub(crate) mod pinhole;
