// Calls the C interface from C#, by P/Invoke on libcoif.so. Does what step_in_c.c does, with the same bits: three heads,
// one asset, two seconds of nodding, and a hash of all matrices of all frames.
//
//   mcs step_in_csharp.cs && LD_LIBRARY_PATH=FOLDER_OF_LIBCOIF mono step_in_csharp.exe bob.coif
using System;
using System.IO;
using System.Runtime.InteropServices;

static class Coif
{
    public const int Ok = 0;

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct HeadPose
    {
        public fixed double Position[3];
        public fixed float Rotation[4];
        public float Scale;
        public float Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct HairDesc
    {
        public uint Instances, Solver, LongestInterval;
        public uint MovingColliders, FollowsBody, FollowsPoses, HasOwnAir, FeelsGusts, DynamicsSets, KeepsLinks;
    }

    // The members of coif_step_settings in their order; vectors are three numbers each.
    [StructLayout(LayoutKind.Sequential)]
    public struct StepSettings
    {
        public float Dt;
        public uint Substeps, Iterations;
        public float GravityX, GravityY, GravityZ, WindX, WindY, WindZ;
        public float AirFollow, Stiffness, Damping, Friction, Inertia, TeleportDistance, TeleportAngle, SleepAfter, SleepSpeed;
        public uint TrueGravity;
    }

    // A view of an asset: plain bytes, which may be moved.
    [StructLayout(LayoutKind.Sequential, Size = 1024)]
    public struct Asset
    {
        ulong inside;
    }

    [DllImport("coif")] public static extern IntPtr coif_version();
    [DllImport("coif")] public static extern IntPtr coif_describe(int status);
    [DllImport("coif")] public static extern void coif_head_pose_init(out HeadPose pose);
    [DllImport("coif")] public static extern void coif_hair_desc_init(out HairDesc desc);
    [DllImport("coif")] public static extern void coif_step_settings_init(out StepSettings settings);
    [DllImport("coif")] public static extern int coif_asset_open(out Asset asset, IntPtr bytes, UIntPtr size, byte[] why, UIntPtr capacity);
    [DllImport("coif")] public static extern IntPtr coif_asset_bones(ref Asset asset, out uint count);
    [DllImport("coif")] public static extern IntPtr coif_asset_bone_name(ref Asset asset, uint bone);
    [DllImport("coif")] public static extern UIntPtr coif_hair_memory_need(IntPtr asset, UIntPtr bytes, ref HairDesc desc);
    [DllImport("coif")] public static extern int coif_hair_create(IntPtr asset, UIntPtr bytes, ref HairDesc desc, IntPtr memory, UIntPtr memoryBytes, out IntPtr hair);
    [DllImport("coif")] public static extern int coif_hair_reset(IntPtr hair, uint instance, ref HeadPose pose);
    [DllImport("coif")] public static extern int coif_hair_set_heads(IntPtr hair, HeadPose[] poses, UIntPtr count);
    [DllImport("coif")] public static extern int coif_hair_step(IntPtr hair, ref StepSettings settings);
    [DllImport("coif")] public static extern IntPtr coif_hair_palette(IntPtr hair, uint instance);

    public static void Check(int status)
    {
        if (status != Ok) throw new InvalidOperationException(Marshal.PtrToStringAnsi(coif_describe(status)));
    }
}

// Memory aligned to 64 bytes, which the garbage collector does not move.
sealed class Block : IDisposable
{
    readonly IntPtr allocated;
    public readonly IntPtr Bytes;
    public readonly UIntPtr Size;

    public Block(ulong size)
    {
        allocated = Marshal.AllocHGlobal(checked((IntPtr)(long)(size + 63)));
        Bytes = (IntPtr)((allocated.ToInt64() + 63) / 64 * 64);
        Size = (UIntPtr)size;
    }

    public static Block OfFile(string path)
    {
        byte[] content = File.ReadAllBytes(path);
        var block = new Block((ulong)content.Length);
        Marshal.Copy(content, 0, block.Bytes, content.Length);
        return block;
    }

    public void Dispose() { Marshal.FreeHGlobal(allocated); }
}

static class StepInCSharp
{
    const int Heads = 3, Frames = 120;

    static unsafe Coif.HeadPose HeadAt(int frame, int head)
    {
        double seconds = frame / 60.0 - 0.1 * head, part = seconds - Math.Floor(seconds);
        double tangent = 3.2 * part * (1 - part) * (0.5 - part), cosine = 1 / Math.Sqrt(1 + tangent * tangent);
        Coif.HeadPose pose;
        Coif.coif_head_pose_init(out pose);
        pose.Position[0] = head;
        pose.Position[1] = 1.7;
        pose.Rotation[0] = (float)(tangent * cosine);
        pose.Rotation[3] = (float)cosine;
        return pose;
    }

    static unsafe ulong HashOf(ulong hash, IntPtr data, long bytes)
    {
        for (byte* next = (byte*)data; bytes > 0; --bytes) hash = unchecked((hash ^ *next++) * 1099511628211UL);
        return hash;
    }

    static ulong Play(IntPtr hair, uint bones)
    {
        var poses = new Coif.HeadPose[Heads];
        Coif.StepSettings settings;
        ulong hash = 14695981039346656037UL;
        Coif.coif_step_settings_init(out settings);
        for (int head = 0; head < Heads; ++head)
        {
            poses[head] = HeadAt(0, head);
            Coif.Check(Coif.coif_hair_reset(hair, (uint)head, ref poses[head]));
        }
        for (int frame = 1; frame <= Frames; ++frame)
        {
            for (int head = 0; head < Heads; ++head) poses[head] = HeadAt(frame, head);
            Coif.Check(Coif.coif_hair_set_heads(hair, poses, (UIntPtr)Heads));
            Coif.Check(Coif.coif_hair_step(hair, ref settings));
            for (int head = 0; head < Heads; ++head)
            {
                hash = HashOf(hash, Coif.coif_hair_palette(hair, (uint)head), 12 * sizeof(float) * bones);
            }
        }
        return hash;
    }

    static void Run(Block file)
    {
        Coif.Asset asset;
        var why = new byte[160];
        if (Coif.coif_asset_open(out asset, file.Bytes, file.Size, why, (UIntPtr)why.Length) != Coif.Ok)
        {
            throw new InvalidDataException(System.Text.Encoding.ASCII.GetString(why, 0, Array.IndexOf(why, (byte)0)));
        }
        uint bones;
        Coif.coif_asset_bones(ref asset, out bones);
        Coif.HairDesc desc;
        Coif.coif_hair_desc_init(out desc);
        desc.Instances = Heads;
        using (var memory = new Block((ulong)Coif.coif_hair_memory_need(file.Bytes, file.Size, ref desc)))
        {
            IntPtr hair;
            Coif.Check(Coif.coif_hair_create(file.Bytes, file.Size, ref desc, memory.Bytes, memory.Size, out hair));
            ulong hash = Play(hair, bones);
            string name = Marshal.PtrToStringAnsi(Coif.coif_asset_bone_name(ref asset, bones - 1));
            string version = Marshal.PtrToStringAnsi(Coif.coif_version());
            Console.WriteLine("coif {0}: {1} bones in {2} bytes, '{3}' moved", version, bones, memory.Size, name);
            Console.WriteLine("matrices {0:x16}", hash);
        }
    }

    static int Main(string[] arguments)
    {
        if (arguments.Length != 1)
        {
            Console.Error.WriteLine("usage: step_in_csharp FILE.coif");
            return 1;
        }
        try
        {
            using (Block file = Block.OfFile(arguments[0])) Run(file);
            return 0;
        }
        catch (Exception failure)
        {
            Console.Error.WriteLine("step_in_csharp: " + arguments[0] + ": " + failure.Message);
            return 1;
        }
    }
}
