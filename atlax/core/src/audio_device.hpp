#pragma once

#include <al.h>
#include <alc.h>

#include <functional>
#include <string>
#include <vector>

namespace atlax::detail {

/// How devices are reached; tests put one of their own here.
struct AudioDriver {
    std::function<ALCdevice*(const char* name)> open;
    std::function<bool(ALCdevice*)> connected;
    std::vector<ALCint> attributes;  ///< for the context, ending with 0; empty for none
};
AudioDriver& audioDriver();

/// An open device with its context, which is current. Buffers and sources end with it.
class AudioDevice {
public:
    /// Null as name is the system's choice. Check valid().
    explicit AudioDevice(const char* name);
    ~AudioDevice();
    AudioDevice(const AudioDevice&) = delete;
    AudioDevice& operator=(const AudioDevice&) = delete;

    bool valid() const { return context_ != nullptr; }
    bool connected() const;
    std::string name() const;

private:
    ALCdevice* device_ = nullptr;
    ALCcontext* context_ = nullptr;
};

std::vector<std::string> audioDeviceNames();

}  // namespace atlax::detail
