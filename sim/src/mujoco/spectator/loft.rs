//! Lofts: smooth closed surfaces through rounded cross-sections, as triangle meshes.

use core::f32::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

use glam::Vec3;

/// Number of corners of a cross-section.
const CORNERS: usize = 16;
/// Number of interpolated intervals between given cross-sections.
const SUBDIVISION: usize = 2;
/// Number of cross-sections of a rounded end.
const END_SECTIONS: usize = 3;
/// Minimum half width at an end, m.
const MIN_HALF_WIDTH: f32 = 0.0005;

/// A cross-section: position along the axis, two coordinates of the centre, two half widths; m. The transverse coordinates are
/// y and z for a loft along x, and x and y for a loft along z.
pub(super) type Section = [f32; 5];

/// Axis of a loft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Z,
}

/// Parameters of a loft.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loft {
    pub(super) axis: Axis,
    /// Exponent of the superellipses: 2 for ellipses, larger for shapes closer to rectangles.
    pub(super) exponent: f32,
    /// Radius of the rounded ends, m.
    pub(super) round: f32,
    /// Cross-sections in ascending order along the axis.
    pub(super) sections: &'static [Section],
}

impl Loft {
    /// Writes the mesh; `side`: −1 for the mirror image at the plane y = 0, otherwise 1.
    pub(super) fn write(&self, xml: &mut String, name: &str, side: f32) {
        let sections = self.all();
        let _ = write!(xml, "<mesh name=\"{name}\" inertia=\"shell\" vertex=\"");
        for section in &sections {
            (0..CORNERS)
                .for_each(|corner| vertex(xml, self.corner(section, side, TAU * corner as f32 / CORNERS as f32)));
        }
        for end in [sections.first(), sections.last()].into_iter().flatten() {
            vertex(xml, self.place(end[0], end[1], end[2], side));
        }
        xml.push_str("\" face=\"");
        faces(xml, sections.len());
        xml.push_str("\"/>\n");
    }

    /// Returns the given, the interpolated and the end cross-sections.
    fn all(&self) -> Vec<Section> {
        let last = self.sections.len() - 1;
        let between = (0..last * SUBDIVISION)
            .map(|i| self.between(i / SUBDIVISION, (i % SUBDIVISION) as f32 / SUBDIVISION as f32));
        let ends = |end: Section, way: f32| (1..=END_SECTIONS).map(move |step| self.end(end, way, step));
        let mut all: Vec<Section> = ends(self.sections[0], -1.0).collect();
        all.reverse();
        all.extend(between);
        all.push(self.sections[last]);
        all.extend(ends(self.sections[last], 1.0));
        all
    }

    /// Interpolates between a cross-section and the next by a Catmull-Rom spline (1974).
    fn between(&self, from: usize, t: f32) -> Section {
        let last = self.sections.len() - 1;
        let [a, b, c, d] = [from.saturating_sub(1), from, from + 1, (from + 2).min(last)].map(|i| self.sections[i]);
        core::array::from_fn(|i| {
            let bend = 2.0 * a[i] - 5.0 * b[i] + 4.0 * c[i] - d[i] + (3.0 * (b[i] - c[i]) + d[i] - a[i]) * t;
            b[i] + 0.5 * t * (c[i] - a[i] + t * bend)
        })
    }

    /// Returns a cross-section of a rounded end; `way`: direction along the axis, 1 or −1.
    fn end(&self, [at, u, v, width, height]: Section, way: f32, step: usize) -> Section {
        let (sin, cos) = libm::sincosf(FRAC_PI_2 * step as f32 / END_SECTIONS as f32);
        let less = self.round * (1.0 - cos);
        [at + way * self.round * sin, u, v, (width - less).max(MIN_HALF_WIDTH), (height - less).max(MIN_HALF_WIDTH)]
    }

    /// Returns a corner of a superellipse.
    fn corner(&self, [at, u, v, width, height]: &Section, side: f32, angle: f32) -> Vec3 {
        let (sin, cos) = libm::sincosf(angle);
        let bulge = |part: f32| libm::powf(part.abs(), 2.0 / self.exponent).copysign(part);
        let (along_u, along_v) = (width * bulge(cos), height * bulge(sin));
        let middle = self.place(*at, *u, *v, side);
        middle + self.place(0.0, along_u, along_v, 1.0)
    }

    fn place(&self, at: f32, u: f32, v: f32, side: f32) -> Vec3 {
        match self.axis {
            Axis::X => Vec3::new(at, side * u, v),
            Axis::Z => Vec3::new(u, side * v, at),
        }
    }
}

fn vertex(xml: &mut String, Vec3 { x, y, z }: Vec3) {
    let _ = write!(xml, "{x:.5} {y:.5} {z:.5} ");
}

/// Writes triangles between neighbouring cross-sections, and from both ends to their centres, which follow after all corners.
fn faces(xml: &mut String, sections: usize) {
    let mut face = |a: usize, b: usize, c: usize| {
        let _ = write!(xml, "{a} {b} {c} ");
    };
    let middles = sections * CORNERS;
    for k in 0..CORNERS {
        let next = (k + 1) % CORNERS;
        for base in (0..sections - 1).map(|section| section * CORNERS) {
            let (a, b, c, d) = (base + k, base + next, base + CORNERS + k, base + CORNERS + next);
            face(a, b, d);
            face(a, d, c);
        }
        face(middles, next, k);
        face(middles + 1, middles - CORNERS + k, middles - CORNERS + next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHELL: Loft = Loft {
        axis: Axis::Z,
        exponent: 2.5,
        round: 0.01,
        sections: &[[-0.05, 0.01, 0.02, 0.03, 0.02], [0.0, 0.0, 0.01, 0.04, 0.03], [0.05, 0.0, 0.0, 0.02, 0.02]],
    };

    /// Returns vertices and faces of the mesh.
    fn mesh(side: f32) -> (Vec<Vec3>, Vec<[usize; 3]>) {
        let mut xml = String::new();
        SHELL.write(&mut xml, "shell", side);
        let numbers = |name: &str| -> Vec<f32> {
            let text = xml.split(&format!("{name}=\"")).nth(1).and_then(|rest| rest.split('"').next()).unwrap();
            text.split_whitespace().map(|number| number.parse().unwrap()).collect()
        };
        let faces = numbers("face").as_chunks::<3>().0.iter().map(|face| face.map(|at| at as usize)).collect();
        (numbers("vertex").as_chunks::<3>().0.iter().map(|at| Vec3::from(*at)).collect(), faces)
    }

    #[test]
    fn loft_is_closed_and_its_faces_point_outward() {
        for side in [1.0, -1.0] {
            let (vertices, faces) = mesh(side);
            let edges: Vec<(usize, usize)> =
                faces.iter().flat_map(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)]).collect();
            assert!(edges.iter().all(|(a, b)| edges.iter().filter(|edge| **edge == (*b, *a)).count() == 1));
            let volume: f32 =
                faces.iter().map(|face| face.map(|at| vertices[at])).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
            let cylinder = core::f32::consts::PI * 0.035 * 0.025 * 0.1;
            assert!((0.8..1.4).contains(&(volume / cylinder)), "{volume} {cylinder}");
        }
    }

    #[test]
    fn the_right_loft_mirrors_the_left() {
        let (left, right) = (mesh(1.0).0, mesh(-1.0).0);
        for at in &left {
            let mirrored = Vec3::new(at.x, -at.y, at.z);
            assert!(right.iter().any(|other| other.distance(mirrored) < 2e-5), "{at}");
        }
        assert!((left.iter().map(|at| at.z).fold(0.0, f32::max) - 0.06).abs() < 1e-5);
    }
}
