//! Names of topics, parameters and frames.

use bica_wire::model::{Description, Invalid};

/// Names of a robot in ROS.
#[derive(Clone, Debug)]
pub struct Names {
    /// `/`, or `/NAME` of one of several robots.
    pub namespace: String,
    /// Name of the node.
    pub node: String,
    /// Frame in which the place of odometry is given, if there is one.
    map: Option<String>,
    /// Frames that several robots have in common.
    common: Vec<String>,
}

/// Frames of a tree that have another name in REP 105.
const FRAMES: [(&str, &str); 2] = [("robot", "base_link"), ("odometry", "odom")];

impl Names {
    /// Returns the names of a robot in a namespace, which may be empty.
    ///
    /// # Errors
    /// If ROS refuses the namespace.
    pub fn new(description: &Description, namespace: &str) -> Result<Self, Invalid> {
        let namespace = checked_namespace(namespace)?;
        let placements =
            description.components.iter().flat_map(|one| &one.outputs).filter_map(|output| output.placement.as_ref());
        let map = placements.filter(|one| one.child.as_deref() == Some("odometry")).map(|one| one.frame.clone()).next();
        let (node, common) = (snake(&description.name), Vec::new());
        Ok(Self { namespace: format!("/{namespace}"), node, map, common })
    }

    /// Sets the frames that several robots have in common: their names do not begin with the namespace.
    #[must_use]
    pub fn with_common(self, common: Vec<String>) -> Self {
        Self { common, ..self }
    }

    /// Returns the absolute name of a topic that other nodes know by its short name, such as `scan`.
    #[must_use]
    pub fn public(&self, name: &str) -> String {
        format!("{}/{name}", self.namespace.trim_end_matches('/'))
    }

    /// Returns the absolute name of a topic or service of this node alone, made of parts such as component and output.
    #[must_use]
    pub fn private(&self, parts: &[&str]) -> String {
        let parts: Vec<_> = parts.iter().map(|part| snake(part)).collect();
        self.public(&format!("{}/{}", self.node, parts.join("/")))
    }

    /// Returns the absolute name of the node.
    #[must_use]
    pub fn full(&self) -> String {
        self.public(&self.node)
    }

    /// Returns the absolute name of a topic of a camera, whose frame may have a name that no topic can have.
    #[must_use]
    pub fn camera(&self, frame: &str, topic: &str) -> String {
        self.public(&format!("{}/{topic}", snake(frame)))
    }

    /// Returns the name of a camera's optical frame.
    #[must_use]
    pub fn optical(&self, frame: &str) -> String {
        format!("{}_optical", self.frame(frame))
    }

    /// Returns the name of a frame by REP 105. Those of a robot in a namespace begin with it.
    #[must_use]
    pub fn frame(&self, frame: &str) -> String {
        let known = FRAMES.iter().find(|(own, _)| *own == frame).map(|(_, name)| *name);
        let is_map = self.map.as_deref() == Some(frame);
        let name = known.or_else(|| is_map.then_some("map")).map_or_else(|| snake(frame), str::to_owned);
        if self.common.iter().any(|common| common == frame) {
            return name;
        }
        self.public(&name).trim_start_matches('/').to_owned()
    }
}

/// Returns a namespace without slashes at its ends, if ROS accepts it.
///
/// # Errors
/// The rule that it breaks.
pub fn checked_namespace(text: &str) -> Result<&str, Invalid> {
    let inner = text.strip_prefix('/').unwrap_or(text);
    let inner = inner.strip_suffix('/').unwrap_or(inner);
    let is_name = |part: &str| {
        let begins = part.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_');
        begins && !part.contains("__") && part.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
    };
    if text.is_empty() || text == "/" || inner.split('/').all(is_name) {
        return Ok(inner);
    }
    let help = "each part between two slashes has letters of ASCII, digits and single underscores, and no digit first";
    Err(Invalid::new(format!("ROS refuses the namespace `{text}`"), help))
}

/// Returns a name in the form of ROS: small letters, digits and single underscores, with a letter first.
#[must_use]
pub fn snake(name: &str) -> String {
    let mut snake = String::new();
    let mut before = '_';
    for letter in name.chars() {
        let begins_word = letter.is_uppercase() && (before.is_lowercase() || before.is_ascii_digit());
        if (begins_word || !letter.is_ascii_alphanumeric()) && !snake.is_empty() && !snake.ends_with('_') {
            snake.push('_');
        }
        if letter.is_ascii_alphanumeric() {
            snake.push(letter.to_ascii_lowercase());
        }
        before = letter;
    }
    let snake = snake.trim_end_matches('_');
    if snake.starts_with(|first: char| first.is_ascii_lowercase()) { snake.to_owned() } else { format!("x{snake}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn namespaces_follow_the_rules_of_ros() {
        for (text, inner) in [("", ""), ("/", ""), ("red", "red"), ("/red/", "red"), ("a/_b2", "a/_b2")] {
            assert_eq!(checked_namespace(text), Ok(inner));
        }
        for text in ["7up", "a//b", "//", "a b", "grün", "a__b", "a/7", "a-b", "~a", "{a}"] {
            let refused = checked_namespace(text).expect_err(text);
            assert!(refused.what.contains(text) && refused.help.contains("digits"), "{refused:?}");
        }
    }

    #[test]
    fn names_have_the_form_of_ros() {
        let pairs = [
            ("WallFollower", "wall_follower"),
            ("Store<f32>", "store_f32"),
            ("place_box", "place_box"),
            ("Is2D__x", "is2_d_x"),
            ("3D", "x3_d"),
            ("ä", "x"),
        ];
        for (name, expected) in pairs {
            assert_eq!(snake(name), expected);
        }
    }
}
