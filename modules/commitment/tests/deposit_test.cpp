// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/commitment/deposit.hpp>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>

#ifdef WM3D_WITH_OPENSSL
#include <openssl/objects.h>
#include <openssl/ts.h>
#endif

using namespace wm3d;
using namespace wm3d::commitment;

TEST_CASE("the digest line is sha256sum's") { // "abc": the example of FIPS 180-4
    CHECK(sha256_line("abc", "my file") ==
          "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  my file\n");
}

#ifdef WM3D_WITH_OPENSSL

TEST_CASE("a time stamp request holds the digest, a nonce and the wish for the certificate") {
    const std::string der = timestamp_request("abc");
    const auto* begin = reinterpret_cast<const unsigned char*>(der.data());
    TS_REQ* request = d2i_TS_REQ(nullptr, &begin, static_cast<long>(der.size()));
    REQUIRE(request != nullptr);
    CHECK(begin == reinterpret_cast<const unsigned char*>(der.data()) + der.size());
    CHECK(TS_REQ_get_version(request) == 1);
    CHECK(TS_REQ_get_cert_req(request) != 0);
    CHECK(TS_REQ_get_nonce(request) != nullptr);
    TS_MSG_IMPRINT* imprint = TS_REQ_get_msg_imprint(request);
    const ASN1_OBJECT* algorithm = nullptr;
    X509_ALGOR_get0(&algorithm, nullptr, nullptr, TS_MSG_IMPRINT_get_algo(imprint));
    CHECK(OBJ_obj2nid(algorithm) == NID_sha256);
    ASN1_OCTET_STRING* digest = TS_MSG_IMPRINT_get_msg(imprint);
    REQUIRE(ASN1_STRING_length(digest) == 32);
    CHECK(ASN1_STRING_get0_data(digest)[0] == 0xba);
    CHECK(ASN1_STRING_get0_data(digest)[31] == 0xad);
    TS_REQ_free(request);
    CHECK(timestamp_request("abc") != der); // the nonce is new each time
}

#else

TEST_CASE("without OpenSSL there are no requests, and that is said") {
    CHECK_FALSE(has_timestamps());
    CHECK_THROWS_AS(timestamp_request("abc"), Error);
}

#endif
