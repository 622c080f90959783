//! Build time of trees of different sizes.

use std::fmt::Write;
use std::time::Duration;

use super::generated::Package;

/// Numbers of components.
const SIZES: [usize; 4] = [50, 100, 200, 250];
/// Number of builds of each tree; the minimum time counts.
const BUILDS: usize = 3;
/// Declared rates, in the order in which components get them; the first runs in every cycle.
const RATES: [&str; 5] = ["", "(hz = 50)", "(hz = 20)", "(hz = 10)", "(hz = 5)"];
/// Largest accepted time per component in the largest tree, as a multiple of that in the smallest one. It is above 1
/// because of the checks of the graph, which compare components with links.
const GROWTH: f64 = 1.5;

/// Processor time of the build of each tree, without that of a tree of one component.
pub(super) struct Growth(Vec<(usize, Duration)>);

/// Measures the debug build of trees of components without states, whose dependencies are built before.
///
/// # Errors
/// If the package cannot be written or built.
pub(super) fn measure() -> Result<Growth, String> {
    let package = Package::new("growth")?;
    let one = least(&package, 1)?;
    let each = SIZES.into_iter().map(|size| Ok((size, least(&package, size)?.saturating_sub(one))));
    Ok(Growth(each.collect::<Result<_, String>>()?))
}

/// Returns the minimum processor time of several builds. Another program is built before each.
fn least(package: &Package, components: usize) -> Result<Duration, String> {
    let mut least = Duration::MAX;
    for build in 0..BUILDS {
        package.build(&format!("// {components}, {build}\nfn main() {{}}\n"))?;
        least = least.min(package.build(&program(components))?.busy);
    }
    Ok(least)
}

impl Growth {
    /// Table of the times.
    pub(super) fn table(&self) -> String {
        let mut text = format!("{:<60}{:>16}{:>18}\n", "debug build of a tree of", "all processors", "per component");
        for (size, time) in &self.0 {
            let (seconds, each) = (time.as_secs_f64(), per_component(*size, *time));
            let _ = writeln!(text, "{:<60}{seconds:>14.2} s{each:>15.1} ms", format!("{size} components"));
        }
        text
    }

    /// Returns a message if the time per component of the largest tree is above the limit.
    pub(super) fn judge(&self) -> Option<String> {
        let (&(small, first), &(large, last)) = (self.0.first()?, self.0.last()?);
        let ratio = per_component(large, last) / per_component(small, first);
        let text =
            || format!("a component of a tree of {large} takes {ratio:.2} times as long to build as one of {small}");
        (ratio > GROWTH).then(|| format!("{}; the limit is {GROWTH}", text()))
    }
}

/// Time per component, ms.
fn per_component(components: usize, time: Duration) -> f64 {
    1e3 * time.as_secs_f64() / components as f64
}

/// Source of a program with a tree in which each component requires the two that follow, and every third one modulates
/// the third that follows.
fn program(components: usize) -> String {
    let mut text = "use bica::prelude::*;\n\n".to_owned();
    for component in 0..components {
        let rate = RATES[component % RATES.len()];
        let reads = (component + 1..components).take(2);
        let write = Some(component + 3).filter(|child| component % 3 == 0 && *child < components);
        let (mut links, mut code) = (String::new(), String::new());
        for child in reads {
            let _ = write!(links, ", c{child}: &C{child}");
            let _ = writeln!(code, "        self.0 += c{child}.0;");
        }
        if let Some(child) = write {
            let _ = write!(links, ", c{child}: &mut C{child}");
            let _ = writeln!(code, "        c{child}.0 += 1;");
        }
        let _ = writeln!(text, "struct C{component}(u32);\n\n#[component{rate}]\nimpl C{component} {{");
        text.push_str("    const fn new() -> Self {\n        Self(0)\n    }\n");
        let _ = writeln!(text, "    fn step(&mut self{links}) {{\n        self.0 /= 2;\n{code}    }}\n}}\n");
    }
    let names: Vec<String> = (0..components).map(|component| format!("C{component}")).collect();
    let names = names.join(", ");
    let _ = writeln!(text, "activation_tree! {{ struct Large {{ root: C0, cycle_hz: 100, components: [{names}] }} }}");
    text.push_str(
        "\nfn main() {\n    let mut tree = Box::new(Large::new());\n    tree.tick(Instant::from_millis(0));\n}\n",
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_component_and_link_is_in_the_program() {
        let text = program(250);
        assert_eq!(text.matches("#[component").count(), 250);
        assert_eq!(text.matches(": &C").count(), 2 * 250 - 3);
        assert_eq!(text.matches(": &mut C").count(), 83);
    }

    #[test]
    fn a_time_that_grows_faster_than_the_tree_is_reported() {
        let growth = |last| Growth(vec![(50, Duration::from_millis(500)), (250, Duration::from_millis(last))]);
        assert_eq!(growth(3700).judge(), None);
        assert!(growth(3800).judge().is_some_and(|message| message.contains("1.52 times")));
    }
}
