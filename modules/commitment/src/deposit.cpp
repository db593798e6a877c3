// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/commitment/deposit.hpp>

#include <array>
#include <memory>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/resync/receipt.hpp>

#ifdef WM3D_WITH_OPENSSL
#include <openssl/bn.h>
#include <openssl/sha.h>
#include <openssl/ts.h>
#endif

namespace wm3d::commitment {

std::string sha256_line(std::string_view text, std::string_view file_name) {
    return fmt::format("{}  {}\n", resync::digest_of(text).sha256, file_name);
}

#ifdef WM3D_WITH_OPENSSL

namespace {

template<auto Release>
struct Releaser {
    template<typename T>
    void operator()(T* object) const {
        Release(object);
    }
};
template<typename T, auto Release>
using Owned = std::unique_ptr<T, Releaser<Release>>;

void require(bool done) {
    if (!done)
        throw Error("OpenSSL can't make the time stamp request; date the digest file instead");
}

/// messageImprint: the algorithm and the digest.
Owned<TS_MSG_IMPRINT, TS_MSG_IMPRINT_free> imprint_of(std::string_view text) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
    SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
    Owned<X509_ALGOR, X509_ALGOR_free> algorithm(X509_ALGOR_new());
    Owned<TS_MSG_IMPRINT, TS_MSG_IMPRINT_free> imprint(TS_MSG_IMPRINT_new());
    require(algorithm && imprint &&
            X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr) == 1 &&
            TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get()) == 1 &&
            TS_MSG_IMPRINT_set_msg(imprint.get(), digest.data(), static_cast<int>(digest.size())) == 1);
    return imprint;
}

Owned<ASN1_INTEGER, ASN1_INTEGER_free> random_nonce() {
    Owned<BIGNUM, BN_free> number(BN_new());
    require(number && BN_rand(number.get(), 64, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) == 1);
    Owned<ASN1_INTEGER, ASN1_INTEGER_free> nonce(BN_to_ASN1_INTEGER(number.get(), nullptr));
    require(nonce != nullptr);
    return nonce;
}

} // namespace

bool has_timestamps() {
    return true;
}

std::string timestamp_request(std::string_view text) {
    Owned<TS_REQ, TS_REQ_free> request(TS_REQ_new());
    require(request && TS_REQ_set_version(request.get(), 1) == 1 &&
            TS_REQ_set_msg_imprint(request.get(), imprint_of(text).get()) == 1 &&
            TS_REQ_set_nonce(request.get(), random_nonce().get()) == 1 &&
            TS_REQ_set_cert_req(request.get(), 1) == 1);
    const int size = i2d_TS_REQ(request.get(), nullptr);
    require(size > 0);
    std::string der(static_cast<std::size_t>(size), '\0');
    auto* end = reinterpret_cast<unsigned char*>(der.data());
    require(i2d_TS_REQ(request.get(), &end) == size);
    return der;
}

#else

bool has_timestamps() {
    return false;
}

std::string timestamp_request(std::string_view) {
    throw Error("this build was made without OpenSSL, so it makes no time stamp requests");
}

#endif

} // namespace wm3d::commitment
