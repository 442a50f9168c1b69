#include "audio_device.hpp"

#include <alext.h>
#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

namespace atlax::detail {

namespace {

void ignoreAlsaMessage(const char*, int, const char*, int, const char*, ...) {}

/// A missing device is reported by the log in one line; the libraries below would write ten more to
/// standard error. ALSA is asked through the loader, since only OpenAL needs it.
void quietLibraries() {
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);
    void* alsa = ::dlopen("libasound.so.2", RTLD_LAZY);
    if (alsa == nullptr) return;
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    using SetHandler = int (*)(Handler);
    auto* set = reinterpret_cast<SetHandler>(::dlsym(alsa, "snd_lib_error_set_handler"));  // NOLINT
    if (set != nullptr) set(ignoreAlsaMessage);
}

/// ALC_EXT_disconnect; without it a device counts as connected.
bool isConnected(ALCdevice* device) {
    if (alcIsExtensionPresent(device, "ALC_EXT_disconnect") != ALC_TRUE) return true;
    ALCint connected = ALC_TRUE;
    alcGetIntegerv(device, ALC_CONNECTED, 1, &connected);
    return connected != ALC_FALSE;
}

ALCenum namesQuery() {
    const bool all = alcIsExtensionPresent(nullptr, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
    return all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER;
}

}  // namespace

AudioDriver& audioDriver() {
    static AudioDriver driver{
        [](const char* name) { return alcOpenDevice(name); }, isConnected, {}};
    return driver;
}

AudioDevice::AudioDevice(const char* name) {
    static const bool quiet = (quietLibraries(), true);
    static_cast<void>(quiet);
    const AudioDriver& driver = audioDriver();
    device_ = driver.open(name);
    if (device_ == nullptr) return;
    context_ =
        alcCreateContext(device_, driver.attributes.empty() ? nullptr : driver.attributes.data());
    if (context_ == nullptr || alcMakeContextCurrent(context_) == ALC_TRUE) return;
    alcDestroyContext(context_);
    context_ = nullptr;
}

AudioDevice::~AudioDevice() {
    if (context_ != nullptr) {
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
    }
    if (device_ != nullptr) alcCloseDevice(device_);
}

bool AudioDevice::connected() const {
    return audioDriver().connected(device_);
}

std::string AudioDevice::name() const {
    const ALCchar* name = alcGetString(device_, ALC_DEVICE_SPECIFIER);
    return name != nullptr ? name : "";
}

std::vector<std::string> audioDeviceNames() {
    std::vector<std::string> out;
    const ALCchar* names = alcGetString(nullptr, namesQuery());
    while (names != nullptr && *names != '\0') {
        out.emplace_back(names);
        names += std::strlen(names) + 1;
    }
    return out;
}

}  // namespace atlax::detail
