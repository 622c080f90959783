//! Check of every request, before it is handled.

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Redirect, Response};

use super::{Shared, headers};

const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Refuses or passes a request, and adds the headers of the response.
pub(crate) async fn guard(State(shared): State<Arc<Shared>>, request: Request, next: Next) -> Response {
    let mut response = match answer(&shared, &request) {
        None => next.run(request).await,
        Some(response) => response,
    };
    headers::add(response.headers_mut());
    response
}

/// Returns the response to a request that is not passed on; none if it is.
fn answer(shared: &Shared, request: &Request) -> Option<Response> {
    let headers = request.headers();
    let host = only(headers, &header::HOST).unwrap_or_default();
    if !shared.hosts.allows(host) {
        return Some(refuse("this server is not known under that name"));
    }
    // Browsers send the relation of the requesting page to this server; other programs do not.
    if !matches!(text(headers, &FETCH_SITE), None | Some("same-origin" | "none")) {
        return Some(refuse("requests of other sites are refused"));
    }
    if request.method() != Method::GET {
        return Some((StatusCode::METHOD_NOT_ALLOWED, "only GET").into_response());
    }
    if request.uri().path() == "/socket" {
        let is_own = only(headers, &header::ORIGIN).is_some_and(|origin| shared.hosts.is_origin(origin, host));
        return (!is_own).then(|| refuse("pages of another origin are refused"));
    }
    let address = shared.hosts.address_of(host)?;
    Some(Redirect::temporary(&format!("http://{address}{}", request.uri())).into_response())
}

fn text<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    headers.get(name).map(|value| value.to_str().unwrap_or("?"))
}

/// Returns the value of a header that must not occur twice.
fn only<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok();
    if values.next().is_some() { None } else { value }
}

fn refuse(why: &'static str) -> Response {
    (StatusCode::FORBIDDEN, why).into_response()
}
