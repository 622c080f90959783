//! Connections and routes.

use std::net::TcpListener;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::extract::{Extension, Path, State};
use axum::http::{StatusCode, header};
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpStream;
use tokio::sync::watch;

use super::pending_connections::{PendingConnection, PendingConnections};
use super::{Shared, assets, guard, socket};

/// Longest time until the head of a request is complete.
const HEAD_TIME: Duration = Duration::from_secs(5);

/// Accepts connections until `stop` changes.
pub(crate) async fn serve(listener: TcpListener, shared: Arc<Shared>, mut stop: watch::Receiver<bool>) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else { return };
    let routes = routes(&shared, &stop);
    let pending = PendingConnections::default();
    loop {
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            _ = stop.changed() => return,
        };
        match accepted {
            Ok((stream, _)) => drop(tokio::spawn(connection(stream, routes.clone(), pending.add()))),
            // Too many open files, or a connection that was cut before it was accepted.
            Err(_) => tokio::time::sleep(Duration::from_millis(20)).await,
        }
    }
}

async fn connection(stream: TcpStream, routes: Router, pending: Arc<PendingConnection>) {
    let _ = stream.set_nodelay(true);
    let service = TowerToHyperService::new(routes.layer(Extension(Arc::clone(&pending))));
    let served = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_TIME)
        .max_buf_size(64 << 10)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades();
    tokio::select! {
        // An error of a client does not concern others.
        _ = served => {}
        () = pending.needed() => {}
    }
}

fn routes(shared: &Arc<Shared>, stop: &watch::Receiver<bool>) -> Router {
    Router::new()
        .route("/", get(page))
        .route("/socket", get(socket::upgrade))
        .route("/extensions.js", get(modules))
        .route("/extensions/{name}", get(module))
        .route("/{*name}", get(|Path(name): Path<String>| async move { file(&name) }))
        .layer(from_fn_with_state(Arc::clone(shared), guard::guard))
        .with_state((Arc::clone(shared), stop.clone()))
}

type Own = State<(Arc<Shared>, watch::Receiver<bool>)>;

async fn modules(State((shared, _)): Own) -> Response {
    ([(header::CONTENT_TYPE, assets::SCRIPT)], shared.manager.modules()).into_response()
}

async fn page() -> Response {
    let (text, media) = assets::page();
    ([(header::CONTENT_TYPE, media)], text).into_response()
}

/// Returns the module of an extension, `NAME.js`.
async fn module(State((shared, _)): Own, Path(name): Path<String>) -> Response {
    match name.strip_suffix(".js").and_then(|name| shared.manager.module(name)) {
        Some(text) => ([(header::CONTENT_TYPE, assets::SCRIPT)], text.to_owned()).into_response(),
        None => (StatusCode::NOT_FOUND, "the program has no such extension").into_response(),
    }
}

fn file(name: &str) -> Response {
    match assets::file(name) {
        Some((bytes, media)) => ([(header::CONTENT_TYPE, media)], bytes.into_owned()).into_response(),
        None => (StatusCode::NOT_FOUND, "the page has no such file").into_response(),
    }
}
