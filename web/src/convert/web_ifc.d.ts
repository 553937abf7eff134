/** What is used of web-ifc's WebAssembly: build_convert.mjs takes the module out of the package, without the classes of the schema. */
declare module 'web-ifc-module' {
  interface List<T> {
    size(): number;
    get(index: number): T;
  }
  export interface Line {
    ID: number;
    type: number;
    arguments: unknown[];
  }
  export interface IfcModule {
    HEAPU8: Uint8Array;
    HEAPF32: Float32Array;
    HEAPU32: Uint32Array;
    SetLogLevel(level: number): void;
    OpenModel(settings: object, read: (to: number, from: number, size: number) => number): number;
    GetLines(model: number, ids: number[]): (Line | undefined)[];
    GetAllLines(model: number): List<number>;
    GetLineType(model: number, id: number): number;
    GetLineIDsWithType(model: number, types: number[]): List<number>;
    GetNameFromTypeCode(type: number): string;
    GetTypeCodeFromName(name: string): number;
    StreamAllMeshes(
      model: number,
      each: (mesh: {
        expressID: number;
        geometries: List<{ geometryExpressID: number; flatTransformation: number[] }>;
      }) => void,
      metres: boolean,
    ): void;
    GetGeometry(
      model: number,
      id: number,
    ): {
      GetVertexData(): number;
      GetVertexDataSize(): number;
      GetIndexData(): number;
      GetIndexDataSize(): number;
      delete(): void;
    };
  }
  export default function (options: object): Promise<IfcModule>;
}
declare module 'web-ifc-wasm' {
  /** The module's bytes. */
  export default function (): Promise<ArrayBuffer>;
}
