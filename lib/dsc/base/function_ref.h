// SPDX-License-Identifier: MIT
// A reference to something that can be called, for functions that call it before they return.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace dsc {

template <class Signature>
class FunctionRef;

/// Two words that refer to a function object; unlike std::function it never allocates, and does not
/// keep the object alive.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    /// Refers to `function`, which has to outlive it.
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             std::is_object_v<std::remove_reference_t<Function>>)
        FunctionRef(Function&& function) // NOLINT: implicit, so that any function object fits
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* object, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Function>*>(object))(
                  std::forward<Arguments>(arguments)...);
          }) {}

    /// Calls the function object.
    Result operator()(Arguments... arguments) const {
        return call_(object_, std::forward<Arguments>(arguments)...);
    }

private:
    void* object_;
    Result (*call_)(void*, Arguments...);
};

} // namespace dsc
