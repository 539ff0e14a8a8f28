#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// An object of a JSON text that knows its place in it, so that errors can say where:
/// "'levels[2].width' is text, expected a whole number".
///
/// The JSON must outlive it.
class JsonObject {
public:
    using Json = nlohmann::ordered_json;

    /// place  of it, as in 'levels[2]'; empty: the whole text
    /// Throws Error where it is no object.
    JsonObject(const Json& json, std::string place);

    [[nodiscard]] bool has(const std::string& field) const;

    /// Reads a field. Throws Error where it is missing, or of another kind than `value`.
    template <class T>
    void get(const std::string& field, T& value) const
    {
        read(at(field), place_of(field), value);
    }

    /// Reads a field that may be missing; the value stays as it is, then.
    template <class T>
    void get_if_there(const std::string& field, T& value) const
    {
        if (has(field))
            get(field, value);
    }

    /// The same; null stands for a missing one, too.
    template <class T>
    void get_if_there(const std::string& field, std::optional<T>& value) const
    {
        if (has(field) && !at(field).is_null())
            get(field, value.emplace());
    }

    [[nodiscard]] JsonObject object(const std::string& field) const;
    [[nodiscard]] std::vector<JsonObject> objects(const std::string& field) const;

private:
    [[nodiscard]] const Json& at(const std::string& field) const;
    [[nodiscard]] std::string place_of(const std::string& field) const;

    static void read(const Json& json, const std::string& place, bool& value);
    static void read(const Json& json, const std::string& place, int& value);
    static void read(const Json& json, const std::string& place, long long& value);
    static void read(const Json& json, const std::string& place, double& value);
    static void read(const Json& json, const std::string& place, std::string& value);
    static void read(const Json& json, const std::string& place, std::vector<std::string>& value);
    static void read(const Json& json, const std::string& place, std::vector<double>& value);
    static void read(const Json& json, const std::string& place,
                     std::map<std::string, std::string>& value);

    static void expect_list(const Json& json, const std::string& place, size_t size);

    template <class T, size_t N>
    static void read(const Json& json, const std::string& place, std::array<T, N>& value)
    {
        expect_list(json, place, N);
        for (size_t i = 0; i < N; ++i)
            read(json[i], element(place, i), value[i]);
    }

    static std::string element(const std::string& place, size_t index);

    const Json* json_;
    std::string place_;
};

} // namespace scree
