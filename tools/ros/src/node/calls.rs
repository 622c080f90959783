//! Services and topics for modulations, actions of the world, holds, the lease, and the pause.

use bica::Hold;
use bica_link::Error;
use bica_recording::ros::{Empty, Names, Numbers, Parameter, SetResult};
use bica_wire::message::{Offers, WorldChange};
use bica_wire::model::{Description, Invalid, Kind, Modulation, NamedRequest, Param, Plain};
use ros2_client::RmwRequestId;
use ros2_client::dds::{Server, Subscription};

use super::network::Network;
use super::pending::{Reply, result};
use super::robot::Robot;
use super::values::plain;
use crate::message::{Nothing, Parameters, SingleResult, TriggerResponse};

/// Effect of a service.
#[derive(Clone, Debug)]
pub(super) enum Target {
    Acquire,
    Take,
    Release,
    /// Stops the robot, without the lease.
    Stop,
    World(WorldChange),
    /// Holds of components, by their names.
    Hold,
    /// A modulation of a component, or, without a component, an action of the world.
    Call(Option<String>, Modulation),
}

/// A service without arguments, or with named ones.
enum Served {
    Trigger(Server<Nothing, TriggerResponse>),
    Named(Server<Parameters, SingleResult>),
}

struct Service {
    target: Target,
    served: Served,
    /// Topic that takes the arguments as numbers, in their order, without an answer.
    numbers: Option<Subscription<Numbers>>,
    /// Topic that stops the robot, without an answer.
    stops: Option<Subscription<Empty>>,
}

/// The services.
pub(super) struct Calls(Vec<Service>);

/// Returns the services of a robot: name, description and target of each.
pub(super) fn services(description: &Description, can_pause: bool, names: &Names) -> Vec<(String, String, Target)> {
    let own = |parts: &[&str], target| {
        (names.private(parts), format!("the service that calls `{}`", parts.join(" ")), target)
    };
    let mut all = vec![
        own(&["lease", "acquire"], Target::Acquire),
        own(&["lease", "take"], Target::Take),
        own(&["lease", "release"], Target::Release),
        own(&["hold"], Target::Hold),
    ];
    if description.stops().next().is_some() {
        all.push(own(&["stop"], Target::Stop));
    }
    if can_pause {
        all.push(own(&["pause"], Target::World(WorldChange::Pause)));
        all.push(own(&["resume"], Target::World(WorldChange::Resume)));
    }
    for component in &description.components {
        for called in &component.modulations {
            let (owner, name) = (&component.name, &called.name);
            let target = Target::Call(Some(owner.clone()), called.clone());
            all.push((names.private(&[owner, name]), format!("the modulation `{owner}.{name}`"), target));
        }
    }
    for action in &description.actions {
        let name = &action.name;
        let target = Target::Call(None, action.clone());
        all.push((names.private(&["world", name]), format!("the action of the world `{name}`"), target));
    }
    all
}

impl Target {
    /// Returns whether it has arguments, all of which are numbers: then a topic takes them, too.
    pub(super) fn takes_numbers(&self) -> bool {
        let is_number = |kind: &Kind| matches!(kind, Kind::F32 { .. } | Kind::I32 { .. } | Kind::U32 { .. });
        let Self::Call(_, Modulation { arguments, .. }) = self else { return false };
        !arguments.is_empty() && arguments.iter().all(|one| is_number(&one.kind))
    }
}

impl Calls {
    pub(super) fn serve(network: &mut Network, robot: &Robot, names: &Names) -> Result<Self, Invalid> {
        let can_pause = robot.link.offers().contains(Offers::PAUSE);
        let all = services(robot.link.description(), can_pause, names);
        let serve = |(name, _, target): (String, String, Target)| Service::serve(network, &name, target);
        all.into_iter().map(serve).collect::<Result<_, _>>().map(Self)
    }

    /// Passes calls on to the robot, and answers them.
    pub(super) fn handle(&self, robot: &mut Robot) -> Result<(), Error> {
        for (index, service) in self.0.iter().enumerate() {
            service.handle(robot, index)?;
        }
        for (reply, results) in robot.pending.take_complete(|reply| matches!(reply, Reply::Call(..))) {
            let Reply::Call(index, id) = reply else { continue };
            let refused = results.into_iter().find(|one| !one.successful);
            self.0[index].answer(id, refused.map_or(Ok(()), |refused| Err(refused.reason)));
        }
        Ok(())
    }
}

impl Service {
    fn serve(network: &mut Network, name: &str, target: Target) -> Result<Self, Invalid> {
        let called = if let Target::Call(_, called) = &target { Some(called) } else { None };
        let has_arguments = called.map_or(matches!(target, Target::Hold), |called| !called.arguments.is_empty());
        let served = if has_arguments {
            Served::Named(network.serve(name, ("rcl_interfaces", "SetParametersAtomically"))?)
        } else {
            Served::Trigger(network.serve(name, ("std_srvs", "Trigger"))?)
        };
        let numbers = target.takes_numbers().then(|| network.subscribe(name)).transpose()?;
        let stops = matches!(target, Target::Stop).then(|| network.subscribe(name)).transpose()?;
        Ok(Self { target, served, numbers, stops })
    }

    fn handle(&self, robot: &mut Robot, index: usize) -> Result<(), Error> {
        match &self.served {
            Served::Trigger(server) => {
                while let Ok(Some((id, Nothing { .. }))) = server.receive_request() {
                    self.call(robot, index, id, &[])?;
                }
            }
            Served::Named(server) => {
                while let Ok(Some((id, Parameters { parameters }))) = server.receive_request() {
                    self.call(robot, index, id, &parameters)?;
                }
            }
        }
        while let Some(stops) = &self.stops
            && let Ok(Some(_)) = stops.take()
        {
            robot.stop()?;
        }
        let Some((numbers, Target::Call(component, called))) = self.numbers.as_ref().map(|one| (one, &self.target))
        else {
            return Ok(());
        };
        while let Ok(Some((Numbers { data, .. }, info))) = numbers.take() {
            let arguments = data.iter().zip(0..).map(|(value, index)| number(*value, called.arguments.get(index)));
            let request = named(component.as_ref(), called, arguments.collect());
            // A refused message does not end the operator's silence.
            let sent = match robot.link.description().request(&request) {
                Ok(_) => robot.send(info.publisher_gid(), &request)?,
                Err(invalid) => Err(format!("{}; {}", invalid.what, invalid.help)),
            };
            robot.report(sent);
        }
        Ok(())
    }

    fn call(&self, robot: &mut Robot, index: usize, id: RmwRequestId, parameters: &[Parameter]) -> Result<(), Error> {
        let client = id.writer_gid;
        let done = match &self.target {
            Target::Acquire => robot.operator.acquire(&mut robot.link, client, false),
            Target::Take => robot.operator.acquire(&mut robot.link, client, true),
            Target::Release => robot.operator.release(&mut robot.link, client),
            Target::Stop => {
                let stops = robot.stop()?;
                let batch = robot.pending.begin(Reply::Call(index, id), stops.len());
                stops.iter().enumerate().for_each(|(entry, stop)| robot.pending.requested(*stop, (batch, entry)));
                return Ok(());
            }
            Target::World(change) => robot
                .operator
                .check(&mut robot.link, client)
                .and_then(|()| robot.link.change_world(*change).map(drop).map_err(|error| error.to_string())),
            Target::Hold => {
                let batch = robot.pending.begin(Reply::Call(index, id), parameters.len());
                for (entry, parameter) in parameters.iter().enumerate() {
                    robot.request(client, hold(parameter), (batch, entry))?;
                }
                return Ok(());
            }
            Target::Call(component, called) => {
                let batch = robot.pending.begin(Reply::Call(index, id), 1);
                let request = arguments(called, parameters).map(|values| named(component.as_ref(), called, values));
                return robot.request(client, request, (batch, 0));
            }
        };
        self.answer(id, done);
        Ok(())
    }

    fn answer(&self, id: RmwRequestId, done: Result<(), String>) {
        let SetResult { successful, reason } = result(done);
        // A client that has gone needs no answer.
        let _ = match &self.served {
            Served::Trigger(server) => {
                server.send_response(id, TriggerResponse { success: successful, message: reason })
            }
            Served::Named(server) => {
                server.send_response(id, SingleResult { result: SetResult { successful, reason } })
            }
        };
    }
}

/// Returns a number of a list as a value for an argument. A number without an argument, or a fraction for an integer, stays as it
/// is; it is refused later.
fn number(value: f32, argument: Option<&Param>) -> Plain {
    let is_whole = argument.is_some_and(|one| !matches!(one.kind, Kind::F32 { .. })) && value.fract() == 0.0;
    if is_whole { Plain::Integer(value as i64) } else { Plain::Number(value.into()) }
}

fn named(component: Option<&String>, called: &Modulation, arguments: Vec<Plain>) -> NamedRequest {
    match component {
        Some(component) => {
            NamedRequest::Modulate { component: component.clone(), modulation: called.name.clone(), arguments }
        }
        None => NamedRequest::World { action: called.name.clone(), arguments },
    }
}

/// Returns the arguments in their order; one that is missing has its default value.
fn arguments(called: &Modulation, parameters: &[Parameter]) -> Result<Vec<Plain>, String> {
    let names = || called.arguments.iter().map(|argument| argument.name.as_str()).collect::<Vec<_>>().join(", ");
    if let Some(unknown) = parameters.iter().find(|one| called.arguments.iter().all(|other| other.name != one.name)) {
        return Err(format!("`{}` has no argument `{}`; its arguments are {}", called.name, unknown.name, names()));
    }
    let is_twice = |(index, one): (usize, &Parameter)| parameters[..index].iter().any(|before| before.name == one.name);
    if let Some((_, twice)) = parameters.iter().enumerate().find(|one| is_twice(*one)) {
        return Err(format!("the argument `{}` of `{}` is given twice", twice.name, called.name));
    }
    let value = |argument: &Param| {
        let given = parameters.iter().find(|one| one.name == argument.name);
        given.map_or_else(|| Ok(argument.plain(argument.default)), |one| plain(&one.name, &one.value))
    };
    called.arguments.iter().map(value).collect()
}

fn hold(Parameter { name, value }: &Parameter) -> Result<NamedRequest, String> {
    let hold = match value.string_value.as_str() {
        "active" => Hold::Active,
        "latent" => Hold::Latent,
        "tree" => Hold::Tree,
        other => return Err(format!("`{other}` is no hold of `{name}`; write `active`, `latent` or `tree`")),
    };
    Ok(NamedRequest::Hold { component: name.clone(), hold })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_what_was_sent_or_are_refused() {
        let param = serde_json::json!({ "name": "steps", "doc": "", "unit": null, "kind": "i32", "min": -9, "max": 9, "default": 0 });
        let steps: Param = serde_json::from_value(param).expect("a parameter");
        assert_eq!(number(-3.0, Some(&steps)), Plain::Integer(-3));
        for wrong in [2.5, f32::NAN, f32::INFINITY] {
            assert!(steps.value_of(&number(wrong, Some(&steps))).is_err(), "{wrong}");
        }
        assert_eq!(number(3.0, None), Plain::Number(3.0));
    }

    #[test]
    fn named_arguments_replace_defaults() {
        let description = serde_json::json!({ "name": "go", "doc": "", "arguments": [
            { "name": "speed", "doc": "", "unit": null, "kind": "f32", "min": 0.0, "max": 1.0, "default": 0.5 },
            { "name": "side", "doc": "", "unit": null, "kind": "bool", "default": false },
        ] });
        let called: Modulation = serde_json::from_value(description).expect("a modulation");
        let value = bica_recording::ros::parameter_value(&Plain::Bool(true));
        let given = [Parameter { name: "side".to_owned(), value }];
        assert_eq!(arguments(&called, &given), Ok(vec![Plain::Number(0.5), Plain::Bool(true)]));
        let unknown = [Parameter { name: "sped".to_owned(), ..Parameter::default() }];
        assert!(arguments(&called, &unknown).is_err_and(|error| error.contains("speed, side")));
        let twice = [given[0].clone(), given[0].clone()];
        assert!(arguments(&called, &twice).is_err_and(|error| error.contains("twice")));
    }
}
