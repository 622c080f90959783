//! Camera poses of recorded images, from a CSV file.
//!
//! Columns, found by name: `file`; the rotation `r00` to `r22` from the camera frame (x forward, y left, z up) to the ground
//! frame; the translation `tx_mm`, `ty_mm`, `tz_mm` (mm, origin on the ground between the feet). Optional: `trusted` (1 or
//! 0, default 1) and `horizon_y_at_x159.5` (row of the horizon, for comparison). Other columns are ignored.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use bica_app::Failure;
use bica_vision::projection::{Camera, Intrinsics};
use glam::{Affine3A, Mat3, Vec2, Vec3};

use crate::frame_io::stem;
use crate::table::{Row, Table};

/// Focal length divided by image width, for the camera of a NAO of 2009 (B-Human 2009).
const FOCAL_PER_WIDTH: f32 = 385.54 / 320.0;
const ROTATION: [&str; 9] = ["r00", "r01", "r02", "r10", "r11", "r12", "r20", "r21", "r22"];
const TRANSLATION: [&str; 3] = ["tx_mm", "ty_mm", "tz_mm"];
const HELP: &str = "the columns are file, r00 to r22, tx_mm, ty_mm, tz_mm and trusted";

/// Pose of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    camera_to_ground: Affine3A,
    /// Whether the pose is accurate enough for distances.
    pub trusted: bool,
    /// Row of the horizon in the middle of an image 320 px wide, as given in the file.
    pub horizon: Option<f32>,
}

impl Pose {
    /// Returns the camera for images of this size, px.
    #[must_use]
    pub fn camera(&self, width: usize, height: usize) -> Camera {
        let size = Vec2::new(width as f32, height as f32);
        Camera::new(
            self.camera_to_ground,
            Intrinsics { focal: Vec2::splat(FOCAL_PER_WIDTH * size.x), centre: 0.5 * size },
        )
    }
}

/// Poses in a file, by the stems of the image names.
#[derive(Clone, Debug, Default)]
pub struct Poses(HashMap<String, Pose>);

impl Poses {
    /// Reads a file.
    ///
    /// # Errors
    /// If the file cannot be read or a pose is malformed.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path).map_err(|error| {
            Failure::of_path("read the poses in", path, &error, "name a CSV file with --poses, or leave it out")
        })?;
        Self::parse(&text).map_err(|what| Failure::new(format!("`{}`: {what}", path.display()), HELP))
    }

    fn parse(text: &str) -> Result<Self, String> {
        let table = Table::parse(text)?;
        let file = table.column("file")?;
        let numbers =
            ROTATION.iter().chain(&TRANSLATION).map(|name| table.column(name)).collect::<Result<Vec<_>, _>>()?;
        let optional = Optional { trusted: table.find("trusted"), horizon: table.find("horizon_y_at_x159.5") };
        let mut poses = HashMap::new();
        for row in table.rows() {
            let pose = pose(row, &numbers, optional).map_err(|what| format!("line {}: {what}", row.line))?;
            poses.insert(stem(row.cell(file)).to_owned(), pose);
        }
        Ok(Self(poses))
    }

    /// Returns the pose of an image.
    #[must_use]
    pub fn get(&self, file: &str) -> Option<&Pose> {
        self.0.get(stem(file))
    }
}

/// Optional columns.
#[derive(Clone, Copy)]
struct Optional {
    trusted: Option<usize>,
    horizon: Option<usize>,
}

fn pose(row: &Row, numbers: &[usize], optional: Optional) -> Result<Pose, String> {
    let mut values = [0.0; 12];
    for (value, &column) in values.iter_mut().zip(numbers) {
        if column >= row.len() {
            return Err(format!("{} cells, but the header has more", row.len()));
        }
        let cell = row.cell(column);
        *value =
            cell.parse().ok().filter(|number: &f32| number.is_finite()).ok_or(format!("`{cell}` is not a number"))?;
    }
    let [a, b, c, d, e, f, g, h, i, x, y, z] = values;
    let rotation = Mat3::from_cols_array(&[a, d, g, b, e, h, c, f, i]);
    if (rotation * rotation.transpose() - Mat3::IDENTITY).to_cols_array().iter().any(|off| off.abs() > 0.01) {
        return Err("r00 to r22 are not a rotation matrix".to_owned());
    }
    Ok(Pose {
        camera_to_ground: Affine3A::from_mat3_translation(rotation, 1e-3 * Vec3::new(x, y, z)),
        trusted: optional.trusted.is_none_or(|column| row.cell(column) == "1"),
        horizon: optional.horizon.and_then(|column| row.cell(column).parse().ok()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "file,r00,r01,r02,r10,r11,r12,r20,r21,r22,tx_mm,ty_mm,tz_mm,trusted\n";

    #[test]
    fn poses_are_in_metres_and_found_by_file_name() {
        let poses = Poses::parse(&format!("{HEADER}a/1.png,1,0,0,0,1,0,0,0,1,50,0,500,1\n\n")).unwrap();
        let pose = poses.get("1.png").unwrap();
        assert!(pose.trusted && poses.get("2.png").is_none());
        let eye = pose.camera(320, 240).pose().translation;
        assert!((eye.x - 0.05).abs() < 1e-6 && (eye.z - 0.5).abs() < 1e-6);
        assert!((pose.camera(640, 480).intrinsics().focal.x - 771.08).abs() < 0.01);
    }

    #[test]
    fn camera_axis_meets_ground_as_computed() {
        // The camera is 0.5 m high and looks 45° down: the middle of the image is 0.5 m ahead.
        let row = "1.png,0.70710678,0,0.70710678,0,1,0,-0.70710678,0,0.70710678,0,0,500,0";
        let poses = Poses::parse(&format!("{HEADER}{row}")).unwrap();
        let pose = poses.get("1.png").unwrap();
        let at = pose.camera(320, 240).ground(Vec2::new(160.0, 120.0), 0.0).unwrap();
        assert!(at.distance(Vec2::new(0.5, 0.0)) < 1e-5 && !pose.trusted, "{at}");
    }

    #[test]
    fn malformed_poses_are_refused_with_their_line() {
        let wrong = |text: &str| Poses::parse(text).unwrap_err();
        assert_eq!(wrong(""), "the file is empty");
        assert_eq!(wrong("file,r00\n"), "there is no column `r01`");
        assert_eq!(wrong(&format!("{HEADER}1.png,1,0\n")), "line 2: 3 cells, but the header has more");
        assert_eq!(wrong(&format!("{HEADER}1.png,1,0,0,0,x,0,0,0,1,0,0,0,1")), "line 2: `x` is not a number");
        assert_eq!(
            wrong(&format!("{HEADER}\n1.png,2,0,0,0,1,0,0,0,1,0,0,0,1")),
            "line 3: r00 to r22 are not a rotation matrix"
        );
    }
}
