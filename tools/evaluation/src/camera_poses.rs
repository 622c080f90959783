//! Camera poses from a CSV file.
//!
//! Columns by name: `file`, the rotation `r00` to `r22` from the camera's axes (x forward, y left, z up) to the ground's,
//! the translation `tx_mm`, `ty_mm`, `tz_mm` in millimetres (origin on the ground between the feet), and perhaps `trusted`
//! (1 or 0; 1 if there is no such column) and `horizon_y_at_x159.5` (the row of the horizon, to compare with). Others are
//! passed over.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use bica_vision::projection::{Camera, Intrinsics};
use glam::{Affine3A, Mat3, Vec2, Vec3};

use crate::frame_io::stem;
use bica_console::Failure;

/// Focal length of the camera of a NAO of 2009 for a width of one pixel: 385.54 px at 320 (B-Human 2009).
const FOCAL: f32 = 385.54 / 320.0;
const ROTATION: [&str; 9] = ["r00", "r01", "r02", "r10", "r11", "r12", "r20", "r21", "r22"];
const TRANSLATION: [&str; 3] = ["tx_mm", "ty_mm", "tz_mm"];
const MEND: &str = "the columns are file, r00 to r22, tx_mm, ty_mm, tz_mm and trusted";

/// Where a camera was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    camera_to_ground: Affine3A,
    /// Whether distances may be taken from it.
    pub trusted: bool,
    /// The row of the horizon in the middle of an image 320 pixels wide, as the file has it.
    pub horizon: Option<f32>,
}

impl Pose {
    /// The camera, for images of a size.
    pub fn camera(&self, width: usize, height: usize) -> Camera {
        let size = Vec2::new(width as f32, height as f32);
        Camera::new(self.camera_to_ground, Intrinsics { focal: Vec2::splat(FOCAL * size.x), centre: 0.5 * size })
    }
}

/// The poses of a file by the names of the images, without folder and ending.
#[derive(Clone, Debug, Default)]
pub struct Poses(HashMap<String, Pose>);

impl Poses {
    /// Reads a file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path).map_err(|error| {
            Failure::of_path("read the poses in", path, &error, "name a CSV file with --poses, or leave it out")
        })?;
        Self::parse(&text).map_err(|what| Failure::new(format!("`{}`: {what}", path.display()), MEND))
    }

    fn parse(text: &str) -> Result<Self, String> {
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let (_, heading) = lines.next().ok_or("the file is empty")?;
        let columns: Vec<&str> = heading.split(',').map(str::trim).collect();
        let column = |name: &str| columns.iter().position(|column| *column == name);
        let needed = |name: &str| column(name).ok_or_else(|| format!("there is no column `{name}`"));
        let file = needed("file")?;
        let numbers = ROTATION.iter().chain(&TRANSLATION).map(|name| needed(name)).collect::<Result<Vec<_>, _>>()?;
        let more = More { trusted: column("trusted"), horizon: column("horizon_y_at_x159.5") };
        let mut poses = HashMap::new();
        for (line, text) in lines {
            let cells: Vec<&str> = text.split(',').map(str::trim).collect();
            let pose = pose(&cells, &numbers, more).map_err(|what| format!("line {}: {what}", line + 1))?;
            let name = cells.get(file).copied().unwrap_or_default();
            poses.insert(stem(name).to_owned(), pose);
        }
        Ok(Self(poses))
    }

    /// The pose for an image.
    pub fn get(&self, file: &str) -> Option<&Pose> {
        self.0.get(stem(file))
    }
}

/// Columns that need not be there.
#[derive(Clone, Copy)]
struct More {
    trusted: Option<usize>,
    horizon: Option<usize>,
}

fn pose(cells: &[&str], numbers: &[usize], more: More) -> Result<Pose, String> {
    let mut values = [0.0; 12];
    for (value, &column) in values.iter_mut().zip(numbers) {
        let cell = cells.get(column).ok_or_else(|| format!("{} cells, but the heading has more", cells.len()))?;
        *value = cell.parse().ok().filter(|number: &f32| number.is_finite()).ok_or(format!("`{cell}` is no number"))?;
    }
    let [a, b, c, d, e, f, g, h, i, x, y, z] = values;
    let rotation = Mat3::from_cols_array(&[a, d, g, b, e, h, c, f, i]);
    if (rotation * rotation.transpose() - Mat3::IDENTITY).to_cols_array().iter().any(|off| off.abs() > 0.01) {
        return Err("r00 to r22 are no rotation".to_owned());
    }
    Ok(Pose {
        camera_to_ground: Affine3A::from_mat3_translation(rotation, 1e-3 * Vec3::new(x, y, z)),
        trusted: more.trusted.is_none_or(|column| cells.get(column).is_some_and(|cell| *cell == "1")),
        horizon: more.horizon.and_then(|column| cells.get(column)?.parse().ok()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "file,r00,r01,r02,r10,r11,r12,r20,r21,r22,tx_mm,ty_mm,tz_mm,trusted\n";

    #[test]
    fn a_pose_is_read_in_metres_and_found_by_its_file() {
        let poses = Poses::parse(&format!("{HEADING}a/1.png,1,0,0,0,1,0,0,0,1,50,0,500,1\n\n")).unwrap();
        let pose = poses.get("1.png").unwrap();
        assert!(pose.trusted && poses.get("2.png").is_none());
        let eye = pose.camera(320, 240).pose().translation;
        assert!((eye.x - 0.05).abs() < 1e-6 && (eye.z - 0.5).abs() < 1e-6);
        assert!((pose.camera(640, 480).intrinsics().focal.x - 771.08).abs() < 0.01);
    }

    #[test]
    fn a_camera_that_looks_down_meets_the_ground() {
        // 45° down, half a metre up: the middle of the image is half a metre ahead.
        let row = "1.png,0.70710678,0,0.70710678,0,1,0,-0.70710678,0,0.70710678,0,0,500,0";
        let poses = Poses::parse(&format!("{HEADING}{row}")).unwrap();
        let pose = poses.get("1.png").unwrap();
        let at = pose.camera(320, 240).ground(Vec2::new(160.0, 120.0), 0.0).unwrap();
        assert!(at.distance(Vec2::new(0.5, 0.0)) < 1e-5 && !pose.trusted, "{at}");
    }

    #[test]
    fn what_is_no_pose_is_refused_and_the_line_named() {
        let wrong = |text: &str| Poses::parse(text).unwrap_err();
        assert_eq!(wrong(""), "the file is empty");
        assert_eq!(wrong("file,r00\n"), "there is no column `r01`");
        assert_eq!(wrong(&format!("{HEADING}1.png,1,0\n")), "line 2: 3 cells, but the heading has more");
        assert_eq!(wrong(&format!("{HEADING}1.png,1,0,0,0,x,0,0,0,1,0,0,0,1")), "line 2: `x` is no number");
        assert_eq!(wrong(&format!("{HEADING}\n1.png,2,0,0,0,1,0,0,0,1,0,0,0,1")), "line 3: r00 to r22 are no rotation");
    }
}
