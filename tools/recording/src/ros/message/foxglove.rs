//! Messages of Foxglove for annotations in images, with their definitions of 2026: ROS has no such messages that viewers show.

use super::{Time, messages};

messages!(derive();
    foxglove_msgs/Point2 as ImagePoint { x: f64, y: f64 }
    foxglove_msgs/Color as ImageColor { r: f64, g: f64, b: f64, a: f64 }
    foxglove_msgs/KeyValuePair as KeyValuePair { key: String, value: String }
    foxglove_msgs/CircleAnnotation as CircleAnnotation {
        timestamp: Time, position: ImagePoint, diameter: f64, thickness: f64, fill_color: ImageColor,
        outline_color: ImageColor, metadata: Vec<KeyValuePair>,
    }
    foxglove_msgs/PointsAnnotation as PointsAnnotation {
        timestamp: Time, r#type: u8, points: Vec<ImagePoint>, outline_color: ImageColor, outline_colors: Vec<ImageColor>,
        fill_color: ImageColor, thickness: f64, metadata: Vec<KeyValuePair>,
    }
    foxglove_msgs/TextAnnotation as TextAnnotation {
        timestamp: Time, position: ImagePoint, text: String, font_size: f64, text_color: ImageColor,
        background_color: ImageColor, metadata: Vec<KeyValuePair>,
    }
    foxglove_msgs/ImageAnnotations as ImageAnnotations {
        timestamp: Time, circles: Vec<CircleAnnotation>, points: Vec<PointsAnnotation>, texts: Vec<TextAnnotation>,
        metadata: Vec<KeyValuePair>,
    }
);
