// SPDX-License-Identifier: MIT
#include "continuum/method.hpp"

#include <span>
#include <string>

#include "continuum/ftcs/ftcs.hpp"
#include "continuum/step/evolution.hpp"

namespace shaken::continuum {

namespace {

std::string dataset(std::size_t field) { return "continuum/" + std::string(Flow::names[field]); }

}  // namespace

void save_flow(const Flow& flow, files::CheckpointWriter& out) {
    const auto fields = flow.fields();
    for (std::size_t k = 0; k < fields.size(); ++k) out.put(dataset(k), *fields[k]);
}

void restore_flow(Flow& flow, const files::CheckpointReader& in) {
    const auto fields = flow.fields();
    for (std::size_t k = 0; k < fields.size(); ++k) in.take_into(dataset(k), std::span(*fields[k]));
}

std::unique_ptr<Method> make_method(Setup setup) {
    if (setup.choices.scheme.name == Ftcs::name) return std::make_unique<Ftcs>(std::move(setup));
    return std::make_unique<Evolution>(std::move(setup));
}

}  // namespace shaken::continuum
