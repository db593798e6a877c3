// SPDX-License-Identifier: GPL-3.0-or-later
// Written by generate/streams.py; the secret is the bytes 0, 1, ..., 31.
#pragma once

#include <cstdint>

#include <wm3d/key/stream.hpp>

struct WordVector {
    wm3d::key::Purpose purpose;
    std::uint64_t index, position, word;
};

inline constexpr WordVector word_vectors[] = {
    {wm3d::key::Purpose::watermark, 0u, 0, 0x5645bc12415f493du},
    {wm3d::key::Purpose::watermark, 0u, 1, 0x463df8edfb033d8bu},
    {wm3d::key::Purpose::watermark, 0u, 7, 0x14c6d70334b9a357u},
    {wm3d::key::Purpose::watermark, 0u, 8, 0x606f2c3bbc5eb61bu},
    {wm3d::key::Purpose::watermark, 0u, 511, 0x6f64ecfa970bdc76u},
    {wm3d::key::Purpose::watermark, 0u, 512, 0xa05fcde71cb925c7u},
    {wm3d::key::Purpose::watermark, 0u, 65535, 0x9b2f2b4776da44d4u},
    {wm3d::key::Purpose::watermark, 0u, 65536, 0x3f11e82be6819d4fu},
    {wm3d::key::Purpose::watermark, 0u, 200003, 0xba364569f5ff3978u},
    {wm3d::key::Purpose::watermark, 1u, 0, 0x8c089115b30e1d66u},
    {wm3d::key::Purpose::watermark, 1u, 1, 0xf2224fc705424ef7u},
    {wm3d::key::Purpose::watermark, 1u, 7, 0xeba8f9a22d3df005u},
    {wm3d::key::Purpose::watermark, 1u, 8, 0x7020a26d4900fcf5u},
    {wm3d::key::Purpose::watermark, 1u, 511, 0x2812b3ac506f340eu},
    {wm3d::key::Purpose::watermark, 1u, 512, 0xeaff6ef40610dad3u},
    {wm3d::key::Purpose::watermark, 1u, 65535, 0x10059c6fc4882ca7u},
    {wm3d::key::Purpose::watermark, 1u, 65536, 0xddf256de79b492ecu},
    {wm3d::key::Purpose::watermark, 1u, 200003, 0x62e0d2ce22cad932u},
    {wm3d::key::Purpose::watermark, 5u, 0, 0x97df33af1f57e958u},
    {wm3d::key::Purpose::watermark, 5u, 1, 0xe9386fc306f6d7f8u},
    {wm3d::key::Purpose::watermark, 5u, 7, 0x7a01297301306992u},
    {wm3d::key::Purpose::watermark, 5u, 8, 0x9ec980b8377a2b1du},
    {wm3d::key::Purpose::watermark, 5u, 511, 0xc34a421c89dc3001u},
    {wm3d::key::Purpose::watermark, 5u, 512, 0xb0be26074df5ae42u},
    {wm3d::key::Purpose::watermark, 5u, 65535, 0x830ca2f1d334f628u},
    {wm3d::key::Purpose::watermark, 5u, 65536, 0x0d54eb717e8f4b48u},
    {wm3d::key::Purpose::watermark, 5u, 200003, 0xecfa468db5234e00u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 0, 0x7a5a3bdf90ec23b4u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 1, 0xfb07408d477bef23u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 7, 0xb1459173d439dc4au},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 8, 0x8754b3c68d4135a3u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 511, 0x6e987d3219498ae5u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 512, 0xded2df483c87c2b6u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 65535, 0x859317a8de2fb7e3u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 65536, 0xb77476d072b48d61u},
    {wm3d::key::Purpose::watermark, 18446744073709551615u, 200003, 0x6f6bdfe15e750abeu},
    {wm3d::key::Purpose::payload, 0u, 0, 0x1f59691afbddb74au},
    {wm3d::key::Purpose::payload, 0u, 1, 0x814217f512650a7bu},
    {wm3d::key::Purpose::payload, 0u, 7, 0xb1ebcda7a2f4a64cu},
    {wm3d::key::Purpose::payload, 0u, 8, 0x70fb3c613a6fea3fu},
    {wm3d::key::Purpose::payload, 0u, 511, 0xc74ec71db5195b7cu},
    {wm3d::key::Purpose::payload, 0u, 512, 0x1f4bd53ff971f05eu},
    {wm3d::key::Purpose::payload, 0u, 65535, 0x8e44d292ec2700ceu},
    {wm3d::key::Purpose::payload, 0u, 65536, 0xfe2bce7474a6e414u},
    {wm3d::key::Purpose::payload, 0u, 200003, 0xe9fca2964f8f0b12u},
    {wm3d::key::Purpose::payload, 1u, 0, 0xa59298d2550a128au},
    {wm3d::key::Purpose::payload, 1u, 1, 0x6a2cd6fc6c98ea67u},
    {wm3d::key::Purpose::payload, 1u, 7, 0xf1f83bc5be723a02u},
    {wm3d::key::Purpose::payload, 1u, 8, 0x879e201e83157a33u},
    {wm3d::key::Purpose::payload, 1u, 511, 0xd37098d70f8d1fb7u},
    {wm3d::key::Purpose::payload, 1u, 512, 0x10187667b0810865u},
    {wm3d::key::Purpose::payload, 1u, 65535, 0x3aef32802cd09a3bu},
    {wm3d::key::Purpose::payload, 1u, 65536, 0x353eb0843ee9e375u},
    {wm3d::key::Purpose::payload, 1u, 200003, 0x3db412cda92a334fu},
    {wm3d::key::Purpose::payload, 5u, 0, 0x3d9e89359277c4bbu},
    {wm3d::key::Purpose::payload, 5u, 1, 0x7d461cfdf4ddacf3u},
    {wm3d::key::Purpose::payload, 5u, 7, 0xcd1c8c9f175f0b12u},
    {wm3d::key::Purpose::payload, 5u, 8, 0x58985b887b1b4fceu},
    {wm3d::key::Purpose::payload, 5u, 511, 0xd1208a5bece9115du},
    {wm3d::key::Purpose::payload, 5u, 512, 0x343ca7b1769cd6feu},
    {wm3d::key::Purpose::payload, 5u, 65535, 0xb96880c80c988546u},
    {wm3d::key::Purpose::payload, 5u, 65536, 0x0571920992f99a33u},
    {wm3d::key::Purpose::payload, 5u, 200003, 0x283cfe741df8394bu},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 0, 0xaa6d8b18de6fc99au},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 1, 0xf129d0cfe696e637u},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 7, 0x4f185ddb7e7ba093u},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 8, 0x92353c13960568c9u},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 511, 0x44103a2257c5424du},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 512, 0xe3562c4be723b3bcu},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 65535, 0x923a6728e59c968fu},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 65536, 0xca1c0d00384f8504u},
    {wm3d::key::Purpose::payload, 18446744073709551615u, 200003, 0x637be60f3c204b3au},
    {wm3d::key::Purpose::recipient, 0u, 0, 0x988fbfc52fb5b0efu},
    {wm3d::key::Purpose::recipient, 0u, 1, 0x7fad1a6185e90a5du},
    {wm3d::key::Purpose::recipient, 0u, 7, 0xab48ca3f1e00dfd3u},
    {wm3d::key::Purpose::recipient, 0u, 8, 0xb6a41a06fef951a5u},
    {wm3d::key::Purpose::recipient, 0u, 511, 0xf990713acdd14eafu},
    {wm3d::key::Purpose::recipient, 0u, 512, 0x9cd70f200cdc1a2au},
    {wm3d::key::Purpose::recipient, 0u, 65535, 0x069cfb6214c1bd5bu},
    {wm3d::key::Purpose::recipient, 0u, 65536, 0x1f98b65a84665a0au},
    {wm3d::key::Purpose::recipient, 0u, 200003, 0x1b803823c4ce7e0au},
    {wm3d::key::Purpose::recipient, 1u, 0, 0xd72b84f781a20bc4u},
    {wm3d::key::Purpose::recipient, 1u, 1, 0xcc9a01cff69a577fu},
    {wm3d::key::Purpose::recipient, 1u, 7, 0xcc25f2fd18877d70u},
    {wm3d::key::Purpose::recipient, 1u, 8, 0xec28181706ced8f9u},
    {wm3d::key::Purpose::recipient, 1u, 511, 0x23133e4738500a80u},
    {wm3d::key::Purpose::recipient, 1u, 512, 0xa1738eb5f70271d0u},
    {wm3d::key::Purpose::recipient, 1u, 65535, 0x7a7793d094536253u},
    {wm3d::key::Purpose::recipient, 1u, 65536, 0x2ac26033ca9d8058u},
    {wm3d::key::Purpose::recipient, 1u, 200003, 0xaed7526a1ce7b949u},
    {wm3d::key::Purpose::recipient, 5u, 0, 0x898195d9d3d38fc7u},
    {wm3d::key::Purpose::recipient, 5u, 1, 0xc2b135878b51077bu},
    {wm3d::key::Purpose::recipient, 5u, 7, 0xdee058577c08b873u},
    {wm3d::key::Purpose::recipient, 5u, 8, 0xaf1632573d93bc30u},
    {wm3d::key::Purpose::recipient, 5u, 511, 0x367fe0aba85016b9u},
    {wm3d::key::Purpose::recipient, 5u, 512, 0x98dfc43c16f0df2au},
    {wm3d::key::Purpose::recipient, 5u, 65535, 0x96b249a120a31887u},
    {wm3d::key::Purpose::recipient, 5u, 65536, 0x8fd92be3a89bb868u},
    {wm3d::key::Purpose::recipient, 5u, 200003, 0x887c539994d2acdbu},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 0, 0x7241c115638823e9u},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 1, 0xa0ed7e212d82fbbbu},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 7, 0x17b19523dfb5ded2u},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 8, 0x0800431560fc60eeu},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 511, 0xe0279a716773ce5du},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 512, 0x6a10f93136c6333eu},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 65535, 0x3e7de94b281aacc0u},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 65536, 0x4a16986f7422527cu},
    {wm3d::key::Purpose::recipient, 18446744073709551615u, 200003, 0x0ed1dd7b5257da0au},
    {wm3d::key::Purpose::trial, 0u, 0, 0x38a2e75845b605ebu},
    {wm3d::key::Purpose::trial, 0u, 1, 0x1e672f0266cccfe9u},
    {wm3d::key::Purpose::trial, 0u, 7, 0x711affc93337ec4du},
    {wm3d::key::Purpose::trial, 0u, 8, 0xf0e4910c897e2894u},
    {wm3d::key::Purpose::trial, 0u, 511, 0x2502b2da5c98fa6du},
    {wm3d::key::Purpose::trial, 0u, 512, 0x9c48cf1b6ef209c7u},
    {wm3d::key::Purpose::trial, 0u, 65535, 0xebf3f22ff0a701dau},
    {wm3d::key::Purpose::trial, 0u, 65536, 0xa54a5352d85bbfa0u},
    {wm3d::key::Purpose::trial, 0u, 200003, 0xd3233202fe1f1156u},
    {wm3d::key::Purpose::trial, 1u, 0, 0x88861634ed24d3bdu},
    {wm3d::key::Purpose::trial, 1u, 1, 0x9207838901a2a5e4u},
    {wm3d::key::Purpose::trial, 1u, 7, 0x8b80ff52277b5423u},
    {wm3d::key::Purpose::trial, 1u, 8, 0x5089df00b07d5ad0u},
    {wm3d::key::Purpose::trial, 1u, 511, 0xa831f277a8b5900eu},
    {wm3d::key::Purpose::trial, 1u, 512, 0xfc63f872493cbc02u},
    {wm3d::key::Purpose::trial, 1u, 65535, 0xe4c31adf5b935e6bu},
    {wm3d::key::Purpose::trial, 1u, 65536, 0x6f79ce029c4b57c3u},
    {wm3d::key::Purpose::trial, 1u, 200003, 0xcebf32a213a78971u},
    {wm3d::key::Purpose::trial, 5u, 0, 0xb5c3d337d77f2503u},
    {wm3d::key::Purpose::trial, 5u, 1, 0x2d5fe85717246872u},
    {wm3d::key::Purpose::trial, 5u, 7, 0x8a5cb6881ab7fa2du},
    {wm3d::key::Purpose::trial, 5u, 8, 0xcc64c7e19aea261au},
    {wm3d::key::Purpose::trial, 5u, 511, 0x27bc5d882bbc4612u},
    {wm3d::key::Purpose::trial, 5u, 512, 0xcc54403181b5652au},
    {wm3d::key::Purpose::trial, 5u, 65535, 0x0555fd55ec0ae6d3u},
    {wm3d::key::Purpose::trial, 5u, 65536, 0x898ce143ddd1eae1u},
    {wm3d::key::Purpose::trial, 5u, 200003, 0x058b2348d808e832u},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 0, 0x5f84d6828216a1e5u},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 1, 0x4cf209e7fa8e1a2fu},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 7, 0x2cecee43658563b1u},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 8, 0x3b0a235e744628a3u},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 511, 0x57b3bb1cfe8e79f4u},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 512, 0xfc37c30dd24746dfu},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 65535, 0x6d28b82dede6cefcu},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 65536, 0x062a1022aa2f63ddu},
    {wm3d::key::Purpose::trial, 18446744073709551615u, 200003, 0xeb465254c5a047e9u},
};

struct HeightVector {
    unsigned level;
    std::uint64_t vertex;
    double height; // for rmax = 0.1
};

inline constexpr HeightVector height_vectors[] = {
    {0, 0, -0x1.0b0e7f8b2a6afp-5},      {0, 1, -0x1.71a693a68651cp-5},      {0, 2, -0x1.01e63cd2563c7p-4},
    {0, 11, 0x1.f511e01d37bd2p-5},      {0, 11, 0x1.f511e01d37bd2p-5},      {1, 0, 0x1.340e822b81694p-7},
    {1, 1, 0x1.6d3a98e344076p-4},       {1, 2, 0x1.2eb6b5538a24cp-4},       {1, 11, -0x1.1941fb883ee30p-6},
    {1, 41, 0x1.f20a5f59e2275p-5},      {2, 0, 0x1.12729ecac73b0p-6},       {2, 1, 0x1.6107e79404bd5p-5},
    {2, 2, 0x1.c9cf58748f598p-5},       {2, 11, -0x1.43770b9f99829p-4},     {2, 161, -0x1.f9df3dd4e723fp-5},
    {3, 0, -0x1.df84b44eaa2e0p-7},      {3, 1, 0x1.047af5924ec27p-8},       {3, 2, 0x1.d15b3720f51b7p-6},
    {3, 11, -0x1.0cdce559dd951p-4},     {3, 641, -0x1.b1559bbac943ap-7},    {4, 0, -0x1.60c3cd4c850aep-4},
    {4, 1, -0x1.7a5cbf9bbc145p-5},      {4, 2, -0x1.74f4dd405a3f7p-6},      {4, 11, 0x1.adc23d44702c8p-5},
    {4, 2561, 0x1.64bdd46323604p-6},    {5, 0, 0x1.318f625b2acbdp-6},       {5, 1, 0x1.50b498d67caf8p-4},
    {5, 2, 0x1.398c2f25c1077p-6},       {5, 11, 0x1.a5589f1c64634p-10},     {5, 10241, -0x1.437b975007c41p-4},
    {6, 0, -0x1.0230312e88054p-4},      {6, 1, 0x1.e263715f99b7ap-7},       {6, 2, -0x1.98ea18e0b43ebp-4},
    {6, 11, -0x1.cdb824e1bab4fp-5},     {6, 40961, 0x1.880aafdb9712dp-7},   {7, 0, -0x1.c247e98403887p-7},
    {7, 1, -0x1.3ca87bbb03ed6p-4},      {7, 2, -0x1.acf518d527ac4p-6},      {7, 11, 0x1.525fe447f04bep-4},
    {7, 163841, -0x1.ae863d281b675p-5}, {8, 0, 0x1.32875c8686622p-5},       {8, 1, 0x1.9b54ea3022887p-7},
    {8, 2, 0x1.351b57d240639p-4},       {8, 11, -0x1.bc0c832725165p-5},     {8, 655361, 0x1.175bc232cb8e3p-6},
    {9, 0, 0x1.674609a0f8521p-4},       {9, 1, -0x1.202d56a317c97p-6},      {9, 2, -0x1.3ce76e64caea7p-8},
    {9, 11, -0x1.7bf213e53a415p-5},     {9, 2621441, 0x1.5fadcad986c4dp-9},
};

struct NullVector {
    std::uint64_t seed, number;
    const char* secret;
};

inline constexpr NullVector null_vectors[] = {
    {0u, 0u, "eeefe0f434530847bf21f7304def3caded415fc6f3104b2c670a30ed9c1660c9"},
    {0u, 1u, "0fd7e428e57be20b865fb25aef6b17a1332eab7c365e82103a81d88599b0abbc"},
    {1u, 0u, "8d44e8ff93028e4dd9c1ddc101baa514fdb5b693e870737dfa06861802f65f75"},
    {7u, 123456789u, "44da469d336abe160a0512e21059406692cee512e1bdabdcbf46f9302e393aeb"},
    {18446744073709551615u, 18446744073709551615u,
     "ae2b7f86a63d32ff93c2564578b2ab637bc1b98962a96c5afa5c1f2199b04497"},
};

struct LabelVector {
    const char* label;
    std::uint64_t index;
};

inline constexpr LabelVector label_vectors[] = {
    {"", 0x282390fbe39c8341u},
    {"a", 0xb92fb74982a7c169u},
    {"work and name", 0xca81616e865f9e9cu},
};

inline constexpr const char* fingerprint_vector = "c5c456ec4863b8bc";
inline constexpr const char* commitment_vector =
    "77e9a9f22085a062edff78473a69ae7b167b2501cfe2c300d5aa3a583660b1a2";
