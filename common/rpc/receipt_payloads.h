// What a store says of files, to messages and back.
#ifndef TILEMEND_COMMON_RPC_RECEIPT_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_RECEIPT_PAYLOADS_H_

#include "common/store/file_receipt.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

inline v1::FileReceipt ToProto(const FileReceipt& receipt) {
  v1::FileReceipt proto;
  proto.set_bytes(receipt.bytes);
  proto.set_inode(receipt.inode);
  proto.set_modified(receipt.modified);
  return proto;
}

inline FileReceipt FromProto(const v1::FileReceipt& proto) { return {proto.bytes(), proto.inode(), proto.modified()}; }

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_RECEIPT_PAYLOADS_H_
