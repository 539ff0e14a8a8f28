#include "texset/json_object.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "math/error.h"

namespace scree {

namespace {

const char* kind_of(const JsonObject::Json& json)
{
    switch (json.type()) {
    case JsonObject::Json::value_t::object:
        return "an object";
    case JsonObject::Json::value_t::array:
        return "a list";
    case JsonObject::Json::value_t::string:
        return "text";
    case JsonObject::Json::value_t::boolean:
        return "true or false";
    case JsonObject::Json::value_t::null:
        return "null";
    default:
        return "a number";
    }
}

void expect(bool holds, const JsonObject::Json& json, const std::string& place,
            const std::string& expected)
{
    if (!holds)
        throw Error(fmt::format("{} is {}, expected {}",
                                place.empty() ? "all of it" : "'" + place + "'", kind_of(json),
                                expected));
}

template <class Int>
void read_whole(const JsonObject::Json& json, const std::string& place, Int& value)
{
    expect(json.is_number(), json, place, "a whole number");
    const double number = json.get<double>();
    const double limit = std::ldexp(1.0, std::numeric_limits<Int>::digits);
    if (number != std::floor(number) || number < -limit || number >= limit)
        throw Error(fmt::format("'{}' is {:g}, expected a whole number", place, number));
    value = json.get<Int>();
}

} // namespace

JsonObject::JsonObject(const Json& json, std::string place) : json_(&json), place_(std::move(place))
{
    expect(json.is_object(), json, place_, "an object");
}

bool JsonObject::has(const std::string& field) const { return json_->contains(field); }

JsonObject JsonObject::object(const std::string& field) const
{
    return {at(field), place_of(field)};
}

std::vector<JsonObject> JsonObject::objects(const std::string& field) const
{
    const Json& list = at(field);
    const std::string place = place_of(field);
    expect(list.is_array(), list, place, "a list");
    std::vector<JsonObject> objects;
    for (const Json& json : list)
        objects.emplace_back(json, element(place, objects.size()));
    return objects;
}

const JsonObject::Json& JsonObject::at(const std::string& field) const
{
    const auto found = json_->find(field);
    if (found == json_->end())
        throw Error(fmt::format("'{}' is missing", place_of(field)));
    return *found;
}

std::string JsonObject::place_of(const std::string& field) const
{
    return place_.empty() ? field : place_ + "." + field;
}

std::string JsonObject::element(const std::string& place, size_t index)
{
    return fmt::format("{}[{}]", place, index);
}

void JsonObject::expect_list(const Json& json, const std::string& place, size_t size)
{
    expect(json.is_array(), json, place, fmt::format("a list of {}", size));
    if (json.size() != size)
        throw Error(
            fmt::format("'{}' is a list of {}, expected one of {}", place, json.size(), size));
}

void JsonObject::read(const Json& json, const std::string& place, bool& value)
{
    expect(json.is_boolean(), json, place, "true or false");
    value = json.get<bool>();
}

void JsonObject::read(const Json& json, const std::string& place, int& value)
{
    read_whole(json, place, value);
}

void JsonObject::read(const Json& json, const std::string& place, long long& value)
{
    read_whole(json, place, value);
}

void JsonObject::read(const Json& json, const std::string& place, double& value)
{
    expect(json.is_number(), json, place, "a number");
    value = json.get<double>();
}

void JsonObject::read(const Json& json, const std::string& place, std::string& value)
{
    expect(json.is_string(), json, place, "text");
    value = json.get<std::string>();
}

void JsonObject::read(const Json& json, const std::string& place, std::vector<std::string>& value)
{
    expect(json.is_array(), json, place, "a list of text");
    value.assign(json.size(), "");
    for (size_t i = 0; i < value.size(); ++i)
        read(json[i], element(place, i), value[i]);
}

void JsonObject::read(const Json& json, const std::string& place, std::vector<double>& value)
{
    expect(json.is_array(), json, place, "a list of numbers");
    value.assign(json.size(), 0.0);
    for (size_t i = 0; i < value.size(); ++i)
        read(json[i], element(place, i), value[i]);
}

void JsonObject::read(const Json& json, const std::string& place,
                      std::map<std::string, std::string>& value)
{
    const JsonObject fields(json, place);
    for (const auto& field : json.items())
        fields.get(field.key(), value[field.key()]);
}

} // namespace scree
