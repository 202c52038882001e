// SPDX-License-Identifier: MIT
#include "scene/differences.hpp"

#include <algorithm>

#include "scene/text_visitor.hpp"

namespace shaken::scene {

std::optional<Difference> first_difference(const Scene& one, std::string_view engine, const Scene& other,
                                           std::string_view other_engine) {
    const auto matters = [&](const KeyText& key) {
        if (key.about.part != Part::experiment) return false;
        return key.owner.empty() || (key.owner == engine && key.owner == other_engine);
    };
    const auto said = [](const KeyText* key) { return key && key->value ? *key->value : std::string("not given"); };
    const std::vector<KeyText> ours = keys_of(one), theirs = keys_of(other);
    const auto named = [](const std::vector<KeyText>& keys, const std::string& full) {
        const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyText& k) { return k.full() == full; });
        return found == keys.end() ? nullptr : &*found;
    };
    for (const KeyText& key : ours) {
        const std::string here = said(&key), there = said(named(theirs, key.full()));
        if (matters(key) && here != there) return Difference{key.full(), here, there};
    }
    for (const KeyText& key : theirs)  // of another kind of scene
        if (matters(key) && !named(ours, key.full())) return Difference{key.full(), "not given", said(&key)};
    return std::nullopt;
}

}  // namespace shaken::scene
