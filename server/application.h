#pragma once

#include <string_view>

#include "server/http.h"
#include "server/router.h"
#include "server/service.h"

namespace ossuary::server {

/// Leads each request to its route: who may ask, which methods there are, whether the body is worth
/// reading. Adds to every answer what all of them carry.
class Application : public HttpHandler {
public:
    explicit Application(Service& service) : service_(service) {}

    std::optional<Response> admit(const RequestHead& head, const std::string& id) override;
    Response handle(Request& request) override;
    void complete(Response& response, const RequestHead& head, const std::string& id) override;
    void finished(const Exchange& exchange) override;
    void refused() override;
    [[nodiscard]] bool is_urgent(const RequestHead& head) const override;

private:
    [[nodiscard]] std::optional<Problem> judge(const RequestHead& head, const Route& route) const;
    [[nodiscard]] Response without_route(const RequestHead& head, const std::string& id,
                                         const std::string& allow) const;
    /// Takes the keys that are in their files now.
    void follow_keys();
    [[nodiscard]] bool serves_host(const RequestHead& head) const;

    Service& service_;
};

/// Whether an address to listen on can only be reached from this machine.
[[nodiscard]] bool is_loopback(std::string_view host);

/// A Host header's name without its port, in lower case.
[[nodiscard]] std::string host_name(std::string_view host);

}  // namespace ossuary::server
