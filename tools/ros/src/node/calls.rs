//! Services and topics for modulations, actions of the world, holds, the lease, and the pause.

use bica::Hold;
use bica_link::Error;
use bica_wire::message::{Offers, WorldChange};
use bica_wire::model::{Invalid, Kind, Modulation, NamedRequest, Plain};
use ros2_client::RmwRequestId;
use ros2_client::dds::{Server, Subscription};

use super::network::Network;
use super::parameters::result;
use super::pending::Reply;
use super::robot::Robot;
use super::values::plain;
use crate::message::{Empty, Nothing, Numbers, Parameter, Parameters, SetResult, SingleResult, TriggerResponse};
use crate::names::Names;

/// What a service does.
#[derive(Clone, Debug)]
enum Target {
    Acquire,
    Take,
    Release,
    /// Stops the robot, without the lease.
    Stop,
    World(WorldChange),
    /// Holds of components, by their names.
    Hold,
    /// A modulation with its component, or without one an action of the world.
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
    /// The arguments as numbers, in their order, without an answer.
    numbers: Option<Subscription<Numbers>>,
    /// Stops without an answer.
    stops: Option<Subscription<Empty>>,
}

/// The services.
pub(super) struct Calls(Vec<Service>);

impl Calls {
    pub(super) fn serve(network: &mut Network, robot: &Robot, names: &Names) -> Result<Self, Invalid> {
        let description = robot.link.description();
        let mut all: Vec<(String, Target)> = vec![
            (names.private(&["lease", "acquire"]), Target::Acquire),
            (names.private(&["lease", "take"]), Target::Take),
            (names.private(&["lease", "release"]), Target::Release),
            (names.private(&["hold"]), Target::Hold),
        ];
        if description.stops().next().is_some() {
            all.push((names.private(&["stop"]), Target::Stop));
        }
        if robot.link.offers().contains(Offers::PAUSE) {
            all.push((names.private(&["pause"]), Target::World(WorldChange::Pause)));
            all.push((names.private(&["resume"]), Target::World(WorldChange::Resume)));
        }
        for component in &description.components {
            for called in &component.modulations {
                let name = names.private(&[&component.name, &called.name]);
                all.push((name, Target::Call(Some(component.name.clone()), called.clone())));
            }
        }
        for action in &description.actions {
            all.push((names.private(&["world", &action.name]), Target::Call(None, action.clone())));
        }
        let serve = |(name, target): (String, Target)| Service::serve(network, &name, target);
        all.into_iter().map(serve).collect::<Result<_, _>>().map(Self)
    }

    /// Passes what was called on to the robot, and answers.
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
        let is_number = |kind: &Kind| matches!(kind, Kind::F32 { .. } | Kind::I32 { .. } | Kind::U32 { .. });
        let is_numeric = called.is_some_and(|called| called.arguments.iter().all(|one| is_number(&one.kind)));
        let numbers = (has_arguments && is_numeric).then(|| network.subscribe(name)).transpose()?;
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
            let number = |(value, argument): (&f32, &bica_wire::model::Param)| match argument.kind {
                Kind::F32 { .. } => Plain::Number((*value).into()),
                _ => Plain::Integer(*value as i64),
            };
            let arguments: Vec<_> = data.iter().zip(&called.arguments).map(number).collect();
            let result = robot.send(info.publisher_gid(), &named(component.as_ref(), called, arguments))?;
            robot.report(result);
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
    let value = |argument: &bica_wire::model::Param| {
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
    fn arguments_are_taken_by_name_and_the_others_are_defaults() {
        let description = serde_json::json!({ "name": "go", "doc": "", "arguments": [
            { "name": "speed", "doc": "", "unit": null, "kind": "f32", "min": 0.0, "max": 1.0, "default": 0.5 },
            { "name": "side", "doc": "", "unit": null, "kind": "bool", "default": false },
        ] });
        let called: Modulation = serde_json::from_value(description).expect("a modulation");
        let value = super::super::values::value(&Plain::Bool(true));
        let given = [Parameter { name: "side".to_owned(), value }];
        assert_eq!(arguments(&called, &given), Ok(vec![Plain::Number(0.5), Plain::Bool(true)]));
        let unknown = [Parameter { name: "sped".to_owned(), ..Parameter::default() }];
        assert!(arguments(&called, &unknown).is_err_and(|error| error.contains("speed, side")));
    }
}
